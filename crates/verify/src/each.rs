//! The same of each of two or three things.
//!
//! The library's `map` of an array is a call for each of them wherever the compiler does not see through it, and where a piece takes
//! a few dozen of these they cost more than what they reckon.

/// What `f` makes of both.
#[inline(always)]
pub(crate) fn two<T, U>([a, b]: [T; 2], f: impl Fn(T) -> U) -> [U; 2] {
    [f(a), f(b)]
}

/// What `f` makes of all three.
#[inline(always)]
pub(crate) fn three<T, U>([a, b, c]: [T; 3], f: impl Fn(T) -> U) -> [U; 3] {
    [f(a), f(b), f(c)]
}
