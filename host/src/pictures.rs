//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`plot`] | curve of the tip |
//! | [`figures`] | figures of the paper, and charts |
//! | [`view`] | page for a browser |

pub mod figures;
pub mod plot;
pub mod view;
