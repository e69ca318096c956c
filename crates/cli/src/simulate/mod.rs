//! Scenes with known truth and a scanner in them: what tests, benches and the demo are made from.

pub mod changes;
pub mod scanner;
pub mod scene;
pub mod write;
