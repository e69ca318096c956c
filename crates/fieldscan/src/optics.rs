//! The way of one ray: scattered back where it meets something matt, through panes, over mirrors and wet floors.
//!
//! The power of an echo is counted in that of a white, perpendicular surface at one metre: reflectivity · cos θ / r²
//! (Lambert, filling the footprint), times what panes and mirrors let through on both ways.

use asbuilt_core::geometry::Vec3;

use crate::material::Optics;
use crate::world::View;

/// Panes return a beam up to this angle from their normal, radians: their surface's own sheen, not their mirror image.
pub const MAX_PANE_INCIDENCE: f64 = 10.0 * std::f64::consts::PI / 180.0;
/// Reflectivity that a clean pane seems to have at its normal; its far side answers more weakly.
const PANE_REFLECTIVITY: f64 = 0.3;
const FAR_SIDE: f64 = 0.25;
/// Ways that carry less than this share of the light are not followed.
const MIN_SHARE: f64 = 0.005;
/// Most surfaces on one way.
const MAX_SURFACES: usize = 12;
/// A ray leaves the surface that it comes from by this, metres.
const OFF_M: f64 = 1e-6;

/// Light that came back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Echo {
    /// Length of the way to where it was scattered, metres, as the scanner measures it.
    pub range: f64,
    /// Power; see the module.
    pub power: f64,
    /// Whose surface scattered it.
    pub owner: u32,
}

/// A piece of a way.
struct Leg {
    origin: Vec3,
    direction: Vec3,
    /// Length of the way up to `origin`, metres.
    travelled: f64,
    /// Share of the light that has come so far; the same is lost on the way back.
    share: f64,
    surfaces: usize,
    within_pane: bool,
}

impl Leg {
    /// Of the ray as it leaves the scanner.
    fn first(origin: &Vec3, direction: &Vec3) -> Self {
        Self { origin: *origin, direction: *direction, travelled: 0.0, share: 1.0, surfaces: 0, within_pane: false }
    }
}

/// The echoes of a ray, added to `out`; `weight` is its part of the beam's power.
pub fn echoes(view: &View, origin: &Vec3, direction: &Vec3, weight: f64, max_range: f64, out: &mut Vec<Echo>) {
    // Most ways have one leg: nothing is allocated for them.
    let (mut first, mut legs) = (Some(Leg::first(origin, direction)), Vec::new());
    while let Some(leg) = first.take().or_else(|| legs.pop()) {
        let Some(met) = view.first(&leg.origin, &leg.direction, OFF_M) else { continue };
        let range = leg.travelled + met.range;
        if range > max_range || leg.surfaces >= MAX_SURFACES {
            continue;
        }
        let cos = met.normal.dot(&leg.direction).abs().min(1.0);
        let strength = weight * leg.share * leg.share / (range * range);
        let power = strength * met.material.reflectivity * cos;
        if power > 0.0 {
            out.push(Echo { range: range + met.material.range_bias_m, power, owner: met.owner });
        }
        let place = leg.origin + leg.direction * met.range;
        let mirrored = leg.direction - met.normal * (2.0 * met.normal.dot(&leg.direction));
        let mut next = |direction: Vec3, share: f64, within_pane: bool| {
            if share > MIN_SHARE {
                let surfaces = leg.surfaces + 1;
                legs.push(Leg { origin: place, direction, travelled: range, share, surfaces, within_pane });
            }
        };
        let reflected = met.material.mirrored(cos);
        match met.material.optics {
            Optics::Matt => {}
            Optics::Mirror | Optics::Wet => next(mirrored, leg.share * reflected, false),
            Optics::Glass => {
                let sheen = pane_sheen(cos) * if leg.within_pane { FAR_SIDE } else { 1.0 };
                out.extend((sheen > 0.0).then_some(Echo { range, power: strength * sheen, owner: met.owner }));
                // Both sides of a pane mirror; what the far side mirrors is taken with the near one.
                if !leg.within_pane {
                    next(mirrored, leg.share * 2.0 * reflected / (1.0 + reflected), false);
                }
                next(leg.direction, leg.share * (1.0 - reflected), !leg.within_pane);
            }
        }
    }
}

/// Reflectivity that a pane seems to have; nothing beyond [`MAX_PANE_INCIDENCE`].
fn pane_sheen(cos: f64) -> f64 {
    let angle = cos.min(1.0).acos() / MAX_PANE_INCIDENCE;
    PANE_REFLECTIVITY * (1.0 - angle * angle).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::world::{Surface, World};
    use asbuilt_core::geometry::Solid;

    fn surface(material: Material) -> Surface {
        Surface { material, owner: 0 }
    }

    fn seen(world: &World, direction: Vec3) -> Vec<Echo> {
        let (nothing, mut out) = (World::default(), Vec::new());
        let view = View { fixed: world, passing: &nothing };
        echoes(&view, &Vec3::zeros(), &direction.normalize(), 1.0, 100.0, &mut out);
        out.sort_by(|a, b| b.power.total_cmp(&a.power));
        out
    }

    #[test]
    fn a_pane_answers_near_its_normal_only_and_lets_beams_through() {
        let mut world = World::default();
        world.add_solid(surface(Material::glass()), &Solid::cuboid([2.0, -50.0, -50.0], [2.02, 50.0, 50.0]).unwrap());
        world.add_solid(
            surface(Material::matt(0.8, 0.0)),
            &Solid::cuboid([6.0, -90.0, -90.0], [6.1, 90.0, 90.0]).unwrap(),
        );
        let world = world.built();
        let along = |degrees: f64| {
            let a = degrees.to_radians();
            (seen(&world, Vec3::new(a.cos(), a.sin(), 0.0)), a.cos())
        };
        for (degrees, pane_answers) in [(0.0, true), (5.0, true), (9.9, true), (10.1, false), (40.0, false)] {
            let (echoes, cos) = along(degrees);
            assert_eq!(echoes.iter().any(|e| (e.range * cos - 2.0).abs() < 1e-6), pane_answers, "{degrees}");
            // The wall behind is met, weakened by two surfaces on both ways.
            let wall = echoes.iter().find(|e| (e.range * cos - 6.0).abs() < 1e-6).unwrap();
            let clear = 0.8 * cos / (wall.range * wall.range);
            assert!(wall.power < 0.9 * clear && wall.power > 0.6 * clear, "{degrees}: {}", wall.power / clear);
        }
        let far_side = along(0.0).0.iter().find(|e| (e.range - 2.02).abs() < 1e-6).unwrap().power;
        assert!(far_side < 0.3 * along(0.0).0[0].power, "the double is faint");
    }

    #[test]
    fn a_mirror_shows_what_is_before_it_as_if_behind() {
        let mut world = World::default();
        world.add_solid(surface(Material::mirror()), &Solid::cuboid([2.0, -9.0, -9.0], [2.1, 9.0, 9.0]).unwrap());
        world.add_solid(
            surface(Material::matt(0.8, 0.0)),
            &Solid::cuboid([-5.0, -9.0, -9.0], [-4.0, 9.0, 9.0]).unwrap(),
        );
        let world = world.built();
        // 2 m to the mirror and 6 m back to the wall behind the scanner.
        let echoes = seen(&world, Vec3::x());
        assert!(echoes.iter().any(|e| (e.range - 8.0).abs() < 1e-6));
    }

    #[test]
    fn power_falls_with_range_and_incidence() {
        let mut world = World::default();
        world.add_solid(
            surface(Material::matt(0.5, 0.002)),
            &Solid::cuboid([3.0, -9.0, -9.0], [4.0, 9.0, 9.0]).unwrap(),
        );
        let world = world.built();
        let echo = seen(&world, Vec3::new(1.0, 1.0, 0.0))[0];
        assert!((echo.range - 3.0 * 2f64.sqrt() - 0.002).abs() < 1e-9);
        assert!((echo.power - 0.5 * 0.5f64.sqrt() / 18.0).abs() < 1e-9);
    }
}
