//! Assemblies of STEP: where each instance of a part stands, by closed forms.

#[expect(dead_code, reason = "other tests make more of it")]
mod maker;

use aptc_exchange::{Fault, Outside};
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::fit_surface;
use maker::Step;

const O: [f64; 3] = [0.0; 3];
const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Parts with a plate each, in millimetres.
struct Parts {
    step: Step,
    context: usize,
    /// A frame that is that of the part.
    home: usize,
}

impl Parts {
    fn new() -> Self {
        let mut step = Step::default();
        let mm = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))".into());
        let context = step.add(format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#{mm}))REPRESENTATION_CONTEXT('',''))"
        ));
        let home = step.frame(O, Z, X);
        Self { step, context, home }
    }

    /// A plate from the origin to (10, 20, 0), 5 up in z at x 10.
    fn plate(&mut self) -> usize {
        let p = [[0.0, 0.0, 0.0], [0.0, 20.0, 0.0], [10.0, 0.0, 5.0], [10.0, 20.0, 5.0]]
            .map(|p| self.step.point(p));
        self.step.add(format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#{},#{}),(#{},#{})),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),\
             (0.,1.),(0.,1.),.UNSPECIFIED.)",
            p[0], p[1], p[2], p[3]
        ))
    }

    /// A representation of these items.
    fn shape(&mut self, items: &[usize]) -> usize {
        let items: Vec<String> =
            items.iter().chain([&self.home]).map(|i| format!("#{i}")).collect();
        self.step.add(format!("SHAPE_REPRESENTATION('',({}),#{})", items.join(","), self.context))
    }

    fn product(&mut self, shape: usize) -> usize {
        let product = self.step.add("PRODUCT_DEFINITION('','',#1,#1)".into());
        let of = self.step.add(format!("PRODUCT_DEFINITION_SHAPE('','',#{product})"));
        self.step.add(format!("SHAPE_DEFINITION_REPRESENTATION(#{of},#{shape})"));
        product
    }

    /// A relation of two representations by two frames.
    fn relation(&mut self, ends: [usize; 2], frames: [usize; 2]) -> usize {
        let [a, b] = frames;
        let by = self.step.add(format!("ITEM_DEFINED_TRANSFORMATION('','',#{a},#{b})"));
        let [a, b] = ends;
        self.step.add(format!(
            "(REPRESENTATION_RELATIONSHIP('','',#{a},#{b})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{by})\
             SHAPE_REPRESENTATION_RELATIONSHIP())"
        ))
    }

    /// The relation is an occurrence of the second product in the first.
    fn occurrence(&mut self, relation: usize, [whole, part]: [usize; 2]) {
        let usage =
            self.step.add(format!("NEXT_ASSEMBLY_USAGE_OCCURRENCE('','','',#{whole},#{part},$)"));
        let of = self.step.add(format!("PRODUCT_DEFINITION_SHAPE('','',#{usage})"));
        self.step.add(format!("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{of})"));
    }

    /// What a mapped item is that shows a representation at a target.
    fn mapped(&mut self, shape: usize, [origin, target]: [usize; 2]) -> usize {
        let map = self.step.add(format!("REPRESENTATION_MAP(#{origin},#{shape})"));
        self.step.add(format!("MAPPED_ITEM('',#{map},#{target})"))
    }
}

/// The corners (0, 0), (1, 0) and (0, 1) of each surface.
fn corners(file: &Outside) -> Vec<[Vec3; 3]> {
    let of = |s| {
        let s = fit_surface(s).expect("a surface");
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[u, v]| s.at(u, v).point)
    };
    file.surfaces.iter().map(of).collect()
}

/// Where the corners are when the plate stands at `o` with these directions of its x, y and z.
fn due(o: [f64; 3], [x, y, z]: [[f64; 3]; 3]) -> [Vec3; 3] {
    let [o, x, y, z] = [o, x, y, z].map(Vec3::from);
    [o, o + x * 10.0 + z * 5.0, o + y * 20.0]
}

fn same(found: &[[Vec3; 3]], due: &[[Vec3; 3]]) {
    assert_eq!(found.len(), due.len(), "{found:?}");
    for (a, b) in found.as_flattened().iter().zip(due.as_flattened()) {
        assert!((a - b).norm() < 1e-12, "{found:?} {due:?}");
    }
}

fn silent(parts: &Parts) -> Vec<[Vec3; 3]> {
    let file = parts.step.read();
    assert!(file.notes.is_empty(), "{:?}", file.notes);
    corners(&file)
}

const MINUS_X: [f64; 3] = [-1.0, 0.0, 0.0];

#[test]
fn a_part_stands_where_each_of_its_instances_is() {
    for turned in [false, true] {
        for by_usage in [false, true] {
            let mut parts = Parts::new();
            let plate = parts.plate();
            let part = parts.shape(&[plate]);
            let first = parts.step.frame([100.0, 200.0, 300.0], Z, X);
            let second = parts.step.frame([50.0, 0.0, 0.0], Z, Y);
            // Some programs list the frames as items of the whole, and some nothing.
            let empty = format!("SHAPE_REPRESENTATION('',(),#{})", parts.context);
            let whole =
                if by_usage { parts.shape(&[first, second]) } else { parts.step.add(empty) };
            let products = [whole, part].map(|s| parts.product(s));
            for frame in [first, second] {
                let ends = if turned { [whole, part] } else { [part, whole] };
                let frames = if turned { [frame, parts.home] } else { [parts.home, frame] };
                let relation = parts.relation(ends, frames);
                if by_usage {
                    parts.occurrence(relation, products);
                }
            }
            if turned && !by_usage {
                // The second representation holds the first one: the plate stands in nothing.
                same(&silent(&parts), &[due(O, [X, Y, Z])]);
                continue;
            }
            let [a, b] =
                [due([100.0, 200.0, 300.0], [X, Y, Z]), due([50.0, 0.0, 0.0], [Y, MINUS_X, Z])];
            same(&silent(&parts), &[a, b]);
        }
    }
}

/// The frame of the part that is put onto that of the whole need not be its own; and the two may be named the other way round.
#[test]
fn a_frame_of_the_part_comes_onto_that_of_the_whole() {
    for exchanged in [false, true] {
        let mut parts = Parts::new();
        let plate = parts.plate();
        let own = parts.step.frame([10.0, 0.0, 5.0], Z, Y);
        let part = parts.shape(&[plate, own]);
        let at = parts.step.frame([1.0, 2.0, 3.0], Z, X);
        let whole = parts.shape(&[at]);
        parts.relation([part, whole], if exchanged { [at, own] } else { [own, at] });
        // Its y comes along x, so its x along -y; its corner at (10, 0, 5) comes to (1, 2, 3).
        let minus_y = [0.0, -1.0, 0.0];
        same(&silent(&parts), &[due([1.0, 12.0, -2.0], [minus_y, X, Z])]);
    }
}

/// A part in a group that is turned by 90 degrees about x and stands twice; a representation beside that of the product has the
/// plate, in the same frame.
#[test]
fn groups_stand_in_groups() {
    let mut parts = Parts::new();
    let plate = parts.plate();
    let drawn = parts.shape(&[plate]);
    let part = parts.shape(&[]);
    parts.step.add(format!("SHAPE_REPRESENTATION_RELATIONSHIP('','',#{part},#{drawn})"));
    let at = parts.step.frame([0.0, 0.0, 7.0], Z, Y);
    let group = parts.shape(&[at]);
    let up = [[40.0, 0.0, 0.0], [80.0, 0.0, 0.0]];
    let frames = up.map(|o| parts.step.frame(o, [0.0, -1.0, 0.0], X));
    let whole = parts.shape(&frames);
    let products = [whole, group, part].map(|s| parts.product(s));
    let relation = parts.relation([part, group], [parts.home, at]);
    parts.occurrence(relation, [products[1], products[2]]);
    for frame in frames {
        let relation = parts.relation([group, whole], [parts.home, frame]);
        parts.occurrence(relation, [products[0], products[1]]);
    }
    // In the group its x is y and its y -x; there y is z and z is -y.
    let in_place = up.map(|o| due([o[0], -7.0, 0.0], [Z, MINUS_X, [0.0, -1.0, 0.0]]));
    same(&silent(&parts), &in_place);
}

/// What stands as it is drawn comes first, then each instance; faces of a part keep their order.
#[test]
fn the_order_is_that_of_the_file() {
    let mut parts = Parts::new();
    let plates = [parts.plate(), parts.plate()];
    let part = parts.shape(&[plates[1], plates[0]]);
    let at = [30.0, 60.0].map(|x| parts.step.frame([x, 0.0, 0.0], Z, X));
    let own = parts.plate();
    let loose = parts.plate();
    let whole = parts.shape(&[own, at[0], at[1]]);
    parts.relation([part, whole], [parts.home, at[1]]);
    parts.relation([part, whole], [parts.home, at[0]]);
    let _ = loose;
    let xs: Vec<f64> = silent(&parts).iter().map(|c| c[0].x).collect();
    assert_eq!(xs, [0.0, 0.0, 60.0, 60.0, 30.0, 30.0]);
}

#[test]
fn mapped_items_stand_at_their_targets() {
    let mut parts = Parts::new();
    let plate = parts.plate();
    let drawn = parts.shape(&[plate]);
    let at = parts.step.frame([100.0, 0.0, 0.0], Z, Y);
    let items = [parts.mapped(drawn, [parts.home, at]), parts.mapped(drawn, [at, parts.home])];
    parts.shape(&items);
    let [one, other] =
        [due([100.0, 0.0, 0.0], [Y, MINUS_X, Z]), due([0.0, 100.0, 0.0], [[0.0, -1.0, 0.0], X, Z])];
    same(&silent(&parts), &[one, other]);
}

/// Operators scale, and mirror where their second direction lies on the other side.
#[test]
fn mapped_items_are_scaled_and_mirrored() {
    let minus_y = [0.0, -1.0, 0.0];
    // Directions of x, y and z, the scale, and where x, y and z of the part come.
    for (x, y, z, scale, comes) in [
        (Some(X), Some(Y), Some(Z), "2.", [X, Y, Z].map(|d| d.map(|x| 2.0 * x))),
        (Some(X), Some(minus_y), Some(Z), "$", [X, minus_y, Z]),
        (Some(Y), Some(Z), Some(X), "1.", [Y, Z, X]),
        (None, None, None, "0.5", [X, Y, Z].map(|d| d.map(|x| 0.5 * x))),
        (Some(X), Some(Y), Some([0.0, 0.0, -1.0]), "1.", [X, Y, [0.0, 0.0, -1.0]]),
    ] {
        for short in [false, true] {
            let mut parts = Parts::new();
            let plate = parts.plate();
            let drawn = parts.shape(&[plate]);
            let o = parts.step.point([3.0, 4.0, 5.0]);
            let [x, y, z] = [x, y, z].map(|d| match d {
                Some(d) => format!("#{}", parts.step.direction(d)),
                None => "$".to_owned(),
            });
            let names = if short { "''" } else { "'','',$" };
            let target = parts.step.add(format!(
                "CARTESIAN_TRANSFORMATION_OPERATOR_3D({names},{x},{y},#{o},{scale},{z})"
            ));
            let item = parts.mapped(drawn, [parts.home, target]);
            parts.shape(&[item]);
            same(&silent(&parts), &[due([3.0, 4.0, 5.0], comes)]);
        }
    }
}

/// Faces that a representation of a feature names are those of the part, where that stands.
#[test]
fn features_draw_nothing_of_their_own() {
    let mut parts = Parts::new();
    let plate = parts.plate();
    let part = parts.shape(&[plate]);
    parts.shape(&[plate]);
    let at = parts.step.frame([100.0, 0.0, 0.0], Z, X);
    let whole = parts.shape(&[at]);
    for shape in [whole, part] {
        parts.product(shape);
    }
    parts.relation([part, whole], [parts.home, at]);
    same(&silent(&parts), &[due([100.0, 0.0, 0.0], [X, Y, Z])]);
}

#[test]
fn places_that_are_not_read_are_told() {
    let mut parts = Parts::new();
    let plate = parts.plate();
    let part = parts.shape(&[plate]);
    let at = parts.step.frame([100.0, 0.0, 0.0], Z, X);
    let whole = parts.shape(&[at]);
    let lost = parts.relation([part, whole], [parts.home, 1]);
    let why = parts.step.tried().unwrap_err().to_string();
    assert!(
        why.contains(&format!("parts whose place is not read are left out there: #{lost}")),
        "{why}"
    );
    parts.relation([part, whole], [parts.home, at]);
    let file = parts.step.read();
    same(&corners(&file), &[due([100.0, 0.0, 0.0], [X, Y, Z])]);
    assert_eq!(file.notes, [format!("parts whose place is not read are left out there: #{lost}")]);
}

#[test]
fn assemblies_without_an_end_are_refused() {
    // In each other, in itself, and below something.
    for below in [false, true] {
        for n in [1, 2, 5] {
            let mut parts = Parts::new();
            let plate = parts.plate();
            let shapes: Vec<usize> = (0..n).map(|_| parts.shape(&[plate])).collect();
            for k in 0..n {
                parts.relation([shapes[k], shapes[(k + 1) % n]], [parts.home; 2]);
            }
            if below {
                let whole = parts.shape(&[]);
                parts.relation([shapes[0], whole], [parts.home; 2]);
            }
            let why = parts.step.tried().unwrap_err();
            assert!(matches!(&why, Fault::Broken { .. }), "{why}");
            assert!(why.to_string().contains("placed within itself"), "{why}");
        }
    }
    // Two in each of forty, and a hundred within each other.
    for (n, each) in [(40, 2), (100, 1)] {
        let mut parts = Parts::new();
        let plate = parts.plate();
        let mut last = parts.shape(&[plate]);
        for _ in 0..n {
            let whole = parts.shape(&[]);
            for k in 0..each {
                let at = parts.step.frame([f64::from(k), 0.0, 0.0], Z, X);
                parts.relation([last, whole], [parts.home, at]);
            }
            last = whole;
        }
        assert!(matches!(parts.step.tried(), Err(Fault::TooLarge(_))));
    }
    // Ten thousand surfaces, and no more.
    let mut parts = Parts::new();
    let plate = parts.plate();
    let mut last = parts.shape(&[plate]);
    for k in 0..14 {
        let at = parts.step.frame([f64::from(1 << k), 0.0, 0.0], Z, X);
        let whole = parts.shape(&[]);
        for frame in [parts.home, at] {
            parts.relation([last, whole], [parts.home, frame]);
        }
        last = whole;
        let found = parts.step.tried();
        match found {
            Ok(file) => assert_eq!(file.surfaces.len(), 2 << k),
            Err(why) => assert!(k == 13 && matches!(why, Fault::TooLarge(_)), "{k} {why}"),
        }
    }
}
