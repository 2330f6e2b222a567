//! Files that a command writes.
//!
//! | module | contents |
//! |---|---|
//! | [`whole_file`] | files that are written completely or not at all |
//! | [`doc_page`] | page of the documentation with a part that a command writes |

pub mod whole_file;

pub mod doc_page;
