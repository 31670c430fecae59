//! Cards, tokens and statement trees of APT part programs
