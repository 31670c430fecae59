//! The statement that fills CL files, `GOTO/x,y,z[,i,j,k]` on one line, read in one pass.

use super::args::is_coordinate;
use crate::number;

/// Numbers of a plain GOTO line: 3 or 6 of them; `None` for anything else, which the slow way takes.
#[inline]
pub(super) fn goto(line: &[u8], values: &mut [f64; 6]) -> Option<usize> {
    let rest = line.strip_prefix(b"GOTO")?;
    let mut at = blanks(rest, 0);
    if rest.get(at) != Some(&b'/') {
        return None;
    }
    at += 1;
    for (i, value) in values.iter_mut().enumerate() {
        at = blanks(rest, at);
        let (x, end) = number::parse_at(rest, at).filter(|n| is_coordinate(n.0))?;
        *value = x;
        at = blanks(rest, end);
        match rest.get(at) {
            Some(b',') => at += 1,
            None => return matches!(i + 1, 3 | 6).then_some(i + 1),
            Some(_) => return None,
        }
    }
    None
}

#[inline]
fn blanks(text: &[u8], mut at: usize) -> usize {
    while matches!(text.get(at), Some(b' ' | b'\t')) {
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_lines_only() {
        let mut v = [0.0; 6];
        assert_eq!(goto(b"GOTO/1,2.5,-3", &mut v), Some(3));
        assert_eq!(v[..3], [1.0, 2.5, -3.0]);
        assert_eq!(goto(b"GOTO  /   1.,  2., 3.,0, 0 ,1 ", &mut v), Some(6));
        let others =
            ["GOTO/1,2", "GOTO/1,2,", "GOTO/1,2,3,4", "GOTO/1,2,$", "GOTO/1,2,3 $$ c", "GO"];
        for other in others {
            assert_eq!(goto(other.as_bytes(), &mut v), None, "{other}");
        }
        assert_eq!(goto(b"GOTO/1,2,3,4,5,6,7", &mut v), None);
    }
}
