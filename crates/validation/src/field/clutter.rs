//! What nobody drew: things that stand around, a mirror, water, people and a vehicle.

use std::f64::consts::TAU;

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_fieldscan::{Material, Puddle, Surface, World};
use rand::Rng;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

use super::places::Standpoint;

/// Owner of what nobody drew.
pub const NOBODY: u32 = u32::MAX;
/// Free floor around a station, metres.
const AROUND_STATION_M: f64 = 0.9;

fn surface(material: Material) -> Surface {
    Surface { material, owner: NOBODY }
}

/// Adds boxes, tables, a mirror and water to a world, on free floor away from the stations.
pub fn scatter(world: &mut World, floor: &[Standpoint], stations: &[Vec3], rng: &mut ChaCha8Rng) -> Result<()> {
    let away = |p: &&Standpoint| stations.iter().all(|s| (s - p.eye()).norm() > AROUND_STATION_M);
    let free: Vec<&Standpoint> = floor.iter().filter(away).collect();
    let count = 2 + free.len() / 12;
    for spot in free.choose_multiple(rng, count) {
        let material = surface(Material::matt(rng.random_range(0.1..0.8), 0.0));
        if rng.random_bool(0.6) {
            let size = Vec3::new(0.0, 0.0, 0.0).map(|_: f64| rng.random_range(0.25..0.8));
            add_box(world, material, spot.floor, size, rng.random_range(0.0..TAU))?;
        } else {
            table(world, material, spot.floor, rng)?;
        }
    }
    if let Some(spot) = free.choose(rng) {
        let heading = rng.random_range(0.0..TAU);
        add_box(world, surface(Material::mirror()), spot.floor, Vec3::new(0.7, 0.02, 1.7), heading)?;
    }
    if let Some(spot) = free.choose(rng) {
        world.add_puddle(Puddle { centre: spot.floor, radius: rng.random_range(0.4..1.2) });
    }
    Ok(())
}

/// What passes while one station measures: people, and a vehicle outdoors.
pub fn passing(station: &Vec3, outdoors: bool, floor: &[Standpoint], rng: &mut ChaCha8Rng) -> Result<World> {
    let mut world = World::default();
    let near = |p: &&Standpoint| (0.9..5.0).contains(&(p.eye() - station).norm());
    let free: Vec<&Standpoint> = floor.iter().filter(near).collect();
    let people = rng.random_range(0..3);
    for spot in free.choose_multiple(rng, people) {
        let person = Solid::cylinder(spot.floor.into(), 0.22, rng.random_range(1.5..1.9), 16)?;
        world.add_solid(surface(Material::matt(0.3, 0.0)), &person);
    }
    if outdoors
        && rng.random_bool(0.4)
        && let Some(spot) = free.choose(rng)
    {
        let heading = rng.random_range(0.0..TAU);
        add_box(&mut world, surface(Material::matt(0.4, 0.0)), spot.floor, Vec3::new(4.2, 1.8, 1.5), heading)?;
    }
    Ok(world.built())
}

/// A box of this size on a place of the floor, turned.
fn add_box(world: &mut World, surface: Surface, foot: Vec3, size: Vec3, heading: f64) -> Result<()> {
    let half = size * 0.5;
    let solid = Solid::cuboid([-half.x, -half.y, 0.0], [half.x, half.y, size.z])?;
    let turn = nalgebra::Rotation3::from_axis_angle(&Vec3::z_axis(), heading);
    let corners = |t: usize| solid.corners(t).map(|c| foot + turn * c);
    world.add(surface, (0..solid.triangles().len()).map(corners));
    Ok(())
}

fn table(world: &mut World, surface: Surface, foot: Vec3, rng: &mut ChaCha8Rng) -> Result<()> {
    let (heading, length) = (rng.random_range(0.0..TAU), rng.random_range(0.8..1.4));
    let turn = nalgebra::Rotation3::from_axis_angle(&Vec3::z_axis(), heading);
    add_box(world, surface, foot + Vec3::z() * 0.7, Vec3::new(length, 0.6, 0.03), heading)?;
    for (x, y) in [(-0.45, -0.25), (0.45, -0.25), (-0.45, 0.25), (0.45, 0.25)] {
        let leg = foot + turn * Vec3::new(x * length, y, 0.0);
        add_box(world, surface, leg, Vec3::new(0.04, 0.04, 0.7), heading)?;
    }
    Ok(())
}
