//! The database: [`connect`] with settings as psql's ([`config`], [`pgpass`]), [`tables`] of the tour, binary [`copy`].

mod config;
pub mod connect;
pub mod copy;
mod pgpass;
pub mod tables;
