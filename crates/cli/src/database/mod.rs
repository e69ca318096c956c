//! The database: [`connect`] with settings as psql's ([`config`], [`pgpass`]); full [`names`]; the [`tables`], what is
//! [`found`] under their names, how they are created ([`ddl`]) and brought up to date ([`layout`]); binary [`copy`]; which
//! stations have [`origins`].

mod config;
pub mod connect;
pub mod copy;
mod ddl;
mod found;
pub mod layout;
pub mod names;
pub mod origins;
mod pgpass;
pub mod tables;

pub use names::quoted;
