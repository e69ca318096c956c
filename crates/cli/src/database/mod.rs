//! The database: [`connect`], [`tables`] of the tour, binary [`copy`].

pub mod connect;
pub mod copy;
pub mod tables;
