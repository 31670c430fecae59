//! Files of IGES put together from entities.

/// A file of IGES of entities: type (with a thousand times its form), directory line of the matrix, parameters.
pub(crate) fn iges(unit: u32, entities: &[(u32, usize, String)]) -> String {
    told(&format!("1.,{unit},2HMM"), entities)
}

/// The same with the scale, the flag of the unit and its name as they are given.
pub(crate) fn told(unit: &str, entities: &[(u32, usize, String)]) -> String {
    let line = |body: &str, section: char, n: usize| format!("{body:<72}{section}{n:>7}\n");
    let mut out = line("made by a test", 'S', 1);
    let global =
        format!("1H,,1H;,4Htest,8Ha;b,c.ig,4Htest,1H1,32,38,6,308,15,4Htest,{unit},1,0.1;");
    for (k, part) in global.as_bytes().chunks(72).enumerate() {
        out += &line(std::str::from_utf8(part).expect("ASCII"), 'G', k + 1);
    }
    let (mut directory, mut parameters) = (String::new(), String::new());
    let mut n = 0;
    for (k, (kind, matrix, text)) in entities.iter().enumerate() {
        let (form, kind) = (kind / 1000, kind % 1000);
        let (first, body) = (n + 1, format!("{kind},{text};"));
        for part in body.as_bytes().chunks(64) {
            n += 1;
            let held = format!("{:<64}{:>8}", std::str::from_utf8(part).expect("ASCII"), 2 * k + 1);
            parameters += &line(&held, 'P', n);
        }
        let head = format!(
            "{kind:>8}{first:>8}{:>8}{:>8}{:>8}{:>8}{matrix:>8}{:>8}{:>8}",
            0, 0, 0, 0, 0, 0
        );
        directory += &line(&head, 'D', 2 * k + 1);
        let tail = format!("{kind:>8}{:>8}{:>8}{:>8}{form:>8}", 0, 0, n + 1 - first);
        directory += &line(&tail, 'D', 2 * k + 2);
    }
    out + &directory + &parameters + &line("", 'T', 1)
}
