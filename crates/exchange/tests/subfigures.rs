//! What IGES places by matrices of trimmed surfaces and by subfigures, by closed forms.

#[expect(dead_code, reason = "other tests make more of it")]
mod ig;

use aptc_exchange::{Fault, Limits, Outside, read};
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::fit_surface;

type Entity = (u32, usize, String);

fn tried(entities: &[Entity]) -> Result<Outside, Fault> {
    read(&ig::told("1.,2,2HMM", entities), &Limits::default()).expect("IGES")
}

fn of(kind: u32, matrix: usize, text: &str) -> Entity {
    (kind, matrix, text.to_owned())
}

/// From the origin to (10, 20, 0), 5 up in z at x 10.
fn plate(matrix: usize) -> Entity {
    let points = "0.,0.,0.,10.,0.,5.,0.,20.,0.,10.,20.,5.";
    let text =
        format!("1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,{points},0.,1.,0.,1.");
    (128, matrix, text)
}

/// x to y, y to -x, and by (5, 0, 3).
fn turn() -> Entity {
    of(124, 0, "0.,-1.,0.,5.,1.,0.,0.,0.,0.,0.,1.,3.")
}

fn turned(p: Vec3) -> Vec3 {
    Vec3::new(5.0 - p.y, p.x, p.z + 3.0)
}

/// The corners (1, 0) and (0, 1) of each surface.
fn corners(file: &Outside) -> Vec<[Vec3; 2]> {
    let of = |s| {
        let s = fit_surface(s).expect("a surface");
        [s.at(1.0, 0.0).point, s.at(0.0, 1.0).point]
    };
    file.surfaces.iter().map(of).collect()
}

/// The plate carried by maps.
fn stands(file: &Outside, maps: &[&dyn Fn(Vec3) -> Vec3]) {
    let found = corners(file);
    assert_eq!(found.len(), maps.len(), "{found:?}");
    for (found, map) in found.iter().zip(maps) {
        let due = [Vec3::new(10.0, 0.0, 5.0), Vec3::new(0.0, 20.0, 0.0)].map(map);
        assert!(found.iter().zip(due).all(|(a, b)| (a - b).norm() < 1e-12), "{found:?} {due:?}");
    }
}

fn silent(entities: &[Entity]) -> Outside {
    let file = tried(entities).expect("a file");
    assert!(file.notes.is_empty(), "{:?}", file.notes);
    file
}

/// The matrix of a trimmed surface follows those of its surface and of its border, whichever way the border is told.
#[test]
fn trimmed_surfaces_have_matrices_of_their_own() {
    // All of the plate, along its corners in space or its parameters.
    let space = ["0,0,0", "10,0,5", "10,20,5", "0,20,0", "0,0,0"];
    let flat = ["0,0,0", "1,0,0", "1,1,0", "0,1,0", "0,0,0"];
    for in_space in [true, false] {
        for (inner, outer) in [(0, 3), (3, 0), (3, 3), (0, 0)] {
            for kind in [143, 144] {
                let mut all = vec![plate(inner), turn()];
                let corners = if in_space { space } else { flat };
                let matrix = if in_space { inner } else { 0 };
                for w in corners.windows(2) {
                    all.push(of(110, matrix, &format!("{},{}", w[0], w[1])));
                }
                all.push(of(102, 0, "4,5,7,9,11"));
                let border = match (kind, in_space) {
                    (144, true) => "0,1,0,13,2",
                    (144, false) => "0,1,13,0,1",
                    (_, true) => "0,1,1,1,13,1,0",
                    // By the parameters, of curves in space that lead nowhere.
                    _ => "1,2,1,1,5,1,1,13",
                };
                all.push(of(kind - 2, 0, border));
                all.push(of(kind, outer, if kind == 144 { "1,1,0,15" } else { "0,1,1,15" }));
                let file = tried(&all).unwrap();
                let once = |p| if inner + outer > 0 { turned(p) } else { p };
                let twice = |p| if inner > 0 && outer > 0 { turned(turned(p)) } else { once(p) };
                stands(&file, &[&twice]);
            }
        }
    }
    // Without a border, and of patches.
    stands(&silent(&[plate(3), turn(), of(144, 3, "1,0,0,0")]), &[&|p| turned(turned(p))]);
}

/// Scaled, carried by the instance's matrix, then moved; the matrices of what is in it come before.
#[test]
fn subfigures_stand_where_they_are_placed() {
    let file = silent(&[
        plate(0),
        of(308, 0, "0,3Hsub,1,1"),
        of(408, 0, "3,100.,0.,0.,2."),
        of(408, 0, "3,200.,1.,2.,1."),
        // What is left out.
        of(408, 0, "3,,7."),
        of(408, 13, "3,100.,0.,0.,2."),
        turn(),
    ]);
    stands(
        &file,
        &[
            &|p| p * 2.0 + Vec3::new(100.0, 0.0, 0.0),
            &|p| p + Vec3::new(200.0, 1.0, 2.0),
            &|p| p + Vec3::new(0.0, 7.0, 0.0),
            &|p| turned(p * 2.0) + Vec3::new(100.0, 0.0, 0.0),
        ],
    );
    let file =
        silent(&[plate(7), of(308, 7, "0,5Ha,1;b,1,1"), of(408, 7, "3,1.,0.,0.,2."), turn()]);
    stands(&file, &[&|p| turned(turned(turned(p)) * 2.0) + Vec3::x()]);
}

/// A subfigure in another one, by a group; a plate that is in none comes first.
#[test]
fn subfigures_stand_in_subfigures() {
    let file = silent(&[
        plate(0),
        of(308, 0, "0,1Ha,1,1"),
        of(408, 0, "3,100.,0.,0.,2."),
        of(1402, 0, "1,5"),
        of(308, 0, "1,1Hb,1,7"),
        of(408, 0, "9,0.,1000.,0.,3."),
        of(408, 0, "9,0.,0.,0."),
        plate(0),
    ]);
    stands(
        &file,
        &[&|p| p, &|p| p * 6.0 + Vec3::new(300.0, 1000.0, 0.0), &|p| {
            p * 2.0 + Vec3::new(100.0, 0.0, 0.0)
        }],
    );
    // A group places nothing by itself.
    stands(&silent(&[plate(0), of(7402, 0, "1,1")]), &[&|p| p]);
}

#[test]
fn what_is_not_placed_is_told() {
    let told = |entities: &[Entity]| {
        let file = tried(entities).unwrap();
        assert_eq!((file.surfaces.len(), file.notes.len()), (1, 1), "{:?}", file.notes);
        file.notes[0].clone()
    };
    let note = told(&[plate(0), of(412, 0, "1,1.,0.,0.,0.,2,1,30.,0.,0.,0,0")]);
    assert!(note.ends_with("as it is drawn: 1 of type 412 (rectangular array)"), "{note}");
    let note = told(&[plate(0), plate(0), of(308, 0, "0,1Ha,1,1")]);
    assert!(note.starts_with("subfigures that nothing places are not read: line "), "{note}");
    let note = told(&[plate(0), of(1402, 5, "1,1"), turn()]);
    assert!(note.starts_with("the matrices of groups (402) are not regarded: line "), "{note}");
    let why = tried(&[plate(0), of(308, 0, "0,1Ha,1,1")]).unwrap_err();
    assert!(matches!(why, Fault::NoSurface(_)) && why.to_string().contains("nothing places"));
}

#[test]
fn subfigures_that_are_broken_are_refused() {
    let why = |entities: &[Entity]| tried(entities).unwrap_err();
    let sub = of(308, 0, "0,1Ha,1,1");
    assert!(
        why(&[plate(0), sub.clone(), of(408, 0, "1,0.,0.,0.")])
            .to_string()
            .ends_with("no subfigure (308)")
    );
    for scale in ["0.", "1D-200"] {
        let shrunk = why(&[plate(0), sub.clone(), of(408, 0, &format!("3,0.,0.,0.,{scale}"))]);
        assert!(shrunk.to_string().ends_with("to nothing"), "{shrunk}");
    }
    // In itself, and each twice in the next.
    let around =
        [plate(0), of(308, 0, "0,1Ha,2,1,5"), of(408, 0, "3,1.,0.,0."), of(408, 0, "3,2.,0.,0.")];
    let endless = why(&around).to_string();
    assert_eq!(endless, "the subfigure of directory line 3 is placed within itself");
    let mut tower = vec![plate(0), sub];
    for k in 0..40 {
        let last = if k == 0 { 3 } else { 6 * k + 3 };
        let n = 2 * tower.len() + 1;
        tower.push(of(408, 0, &format!("{last},0.,0.,0.")));
        tower.push(of(408, 0, &format!("{last},1.,0.,0.")));
        tower.push(of(308, 0, &format!("0,1Ha,2,{n},{}", n + 2)));
        assert_eq!(2 * tower.len() - 1, 6 * (k + 1) + 3);
    }
    tower.push(of(408, 0, &format!("{},0.,0.,0.", 2 * tower.len() - 1)));
    assert!(matches!(why(&tower), Fault::TooLarge(_)));
    let groups = [
        plate(0),
        of(1402, 0, "1,5"),
        of(1402, 0, "1,3"),
        of(308, 0, "0,1Ha,2,1,3"),
        of(408, 0, "7,0.,0.,0."),
    ];
    assert_eq!(tried(&groups).unwrap().surfaces.len(), 1);
}

/// What is no rotation is told and applied; what flattens is refused.
#[test]
fn matrices_that_are_no_rotations() {
    for (rows, map) in [
        ("2.,0.,0.,0.,0.,2.,0.,0.,0.,0.,2.,0.", [2.0, 2.0, 2.0]),
        ("1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.001,0.", [1.0, 1.0, 1.001]),
    ] {
        let file = tried(&[plate(3), of(124, 0, rows)]).unwrap();
        assert!(
            file.notes.len() == 1 && file.notes[0].contains("no rotations"),
            "{:?}",
            file.notes
        );
        stands(&file, &[&|p| p.component_mul(&Vec3::from(map))]);
    }
    // A mirror, and numbers of few digits.
    for rows in
        ["1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,-1.,0.", ".8660,-.5,0.,0.,.5,.8660,0.,0.,0.,0.,1.,0."]
    {
        silent(&[plate(3), of(124, 0, rows)]);
    }
    for rows in ["0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.", "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,0.,0."] {
        let why = tried(&[plate(3), of(124, 0, rows)]).unwrap_err().to_string();
        assert!(why.ends_with("a matrix (124) flattens what it carries"), "{why}");
    }
    // One that nothing refers to counts for nothing.
    silent(&[plate(0), of(124, 0, "0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.")]);
}
