//! Files of the field with their right answers.
