"""The buildings that make_model.py writes, and what they are made of.

step: a file's lines; mesh: bodies of facets; body: bodies as IFC writes them; layers: walls; openings: windows, doors,
glazing; furniture, sanitary, services, railing: what stands in them; pavilion, office, house: the buildings.
"""
