//! REFSYS and CANON.

use aptc_geometry::{Form, FormKind, Transform, Vec3};
use aptc_vocabulary::{Word, word};

use super::{args, define, n, w};
use crate::define::{Context, DefineError, Fault, Value, canonical};

fn turned() -> Transform {
    let turn = Transform::rotation(Vec3::new(0.3, -0.5, 1.0).normalize(), 40.0);
    turn.then(&Transform::scale(2.0)).then(&Transform::translation(Vec3::new(3.0, -2.0, 5.0)))
}

fn close(a: &Form, b: &Form) -> bool {
    let (x, y) = (a.canonical(), b.canonical());
    a.kind() == b.kind()
        && x.len() == y.len()
        && x.iter().zip(&y).all(|(x, y)| (x - y).abs() < 1e-11)
}

/// One form of each kind that a program can define.
fn samples() -> Vec<(Word, Form)> {
    let point = |x: f64, y: f64, z: f64| Value::from(Vec3::new(x, y, z));
    let vector = Value::from(Form::Vector(Vec3::new(1.0, 2.0, -0.5)));
    let cases: Vec<(Word, Vec<Value>)> = vec![
        (word::POINT, vec![n(1.0), n(2.0), n(3.0)]),
        (word::VECTOR, vec![n(1.0), n(2.0), n(3.0)]),
        (word::LINE, vec![n(1.0), n(2.0), n(3.0), n(5.0)]),
        (word::PLANE, vec![n(1.0), n(2.0), n(3.0), n(5.0)]),
        (word::CIRCLE, vec![n(1.0), n(2.0), n(3.0), n(5.0)]),
        (word::CYLNDR, vec![point(1.0, 1.0, 0.0), vector.clone(), n(2.0)]),
        (word::SPHERE, vec![n(1.0), n(2.0), n(3.0), n(5.0)]),
        (word::CONE, vec![point(0.0, 1.0, 2.0), vector, n(20.0)]),
        (word::ELLIPS, vec![w("CENTER"), point(1.0, 2.0, 0.0), n(3.0), n(2.0), n(25.0)]),
        (word::HYPERB, vec![w("CENTER"), point(1.0, 2.0, 0.0), n(3.0), n(2.0), n(25.0)]),
        (word::GCONIC, [1.0, 0.5, 2.0, -1.0, 3.0, -4.0].map(n).to_vec()),
        (word::QADRIC, [1.0, 0.5, 2.0, 0.1, 0.2, 0.3, -1.0, 3.0, 0.5, -4.0].map(n).to_vec()),
        (word::MATRIX, vec![w("XYROT"), n(30.0), w("TRANSL"), n(1.0), n(2.0)]),
        (
            word::TABCYL,
            [vec![w("NOY"), w("SPLINE")], [0.0, 0.0, 1.0, 0.3, 2.0, 0.2, 3.0, 1.0].map(n).to_vec()]
                .concat(),
        ),
    ];
    cases.into_iter().map(|(head, values)| (head, define(head, &values).unwrap())).collect()
}

#[test]
fn a_definition_in_a_reference_system_is_the_definition_moved() {
    let system = turned();
    let context = Context { refsys: Some(system), ..Context::default() };
    let inverse = system.inverse().unwrap();
    let circle = define(word::CIRCLE, &[n(1.0), n(2.0), n(3.0)]).unwrap();
    let line = define(word::LINE, &[n(0.0), n(0.5), n(1.0), n(1.5)]).unwrap();
    let values = |line: Form, circle: Form| {
        vec![w("YLARGE"), w("INTOF"), Value::from(line), Value::from(circle)]
    };
    // Symbols lie in the base system: what is local here is moved there first.
    let base = (line.transformed(&system).unwrap(), circle.transformed(&system).unwrap());
    let there =
        crate::define::define(word::POINT, &args(&values(base.0, base.1)), &context).unwrap();
    let here = define(word::POINT, &values(line, circle)).unwrap();
    assert!(close(&there.transformed(&inverse).unwrap(), &here));

    // A line that the system tilts stays a LINE, and a line again when it comes back.
    let tilted = crate::define::define(word::LINE, &args(&[w("XAXIS")]), &context).unwrap();
    assert_eq!(tilted.kind(), FormKind::Line);
    assert!(matches!(tilted.shape(), Form::Plane(_)));
    let origin = system.point(Vec3::zeros());
    assert!(matches!(tilted.shape(), Form::Plane(p) if p.distance(origin).abs() < 1e-12));
}

#[test]
fn canonical_elements_give_the_form_back() {
    for (head, form) in samples() {
        let elements: Vec<Value> = form.canonical().into_iter().map(n).collect();
        let again = canonical(head, None, &args(&elements), &Context::default()).unwrap();
        assert!(close(&form, &again), "{head}: {form:?} {again:?}");
        // All fields empty: the same form.
        let empty = vec![Value::Empty; elements.len()];
        let same = canonical(head, Some(&form), &args(&empty), &Context::default()).unwrap();
        assert!(close(&form, &same), "{head}");
        let short = &elements[..elements.len() - 1];
        let refused = canonical(head, None, &args(short), &Context::default());
        assert!(refused.is_err(), "{head} with an element too few");
    }
}

#[test]
fn elements_out_of_shape_are_kept_as_written() {
    let given = [0.0, -0.25, 80.0, 24.9];
    let context = Context::default();
    let line = canonical(word::LINE, None, &args(&given.map(n)), &context).unwrap();
    assert_eq!((line.kind(), line.canonical()), (FormKind::Line, given.to_vec()));
    let Form::Plane(p) = line.shape() else { panic!("{line:?}") };
    assert!((p.n.norm() - 1.0).abs() < 1e-15);

    let circle = define(word::CIRCLE, &[n(1.0), n(2.0), n(5.0)]).unwrap();
    let mut fields = vec![Value::Empty; 6];
    fields.push(n(0.25));
    let smaller = canonical(word::CIRCLE, Some(&circle), &args(&fields), &context).unwrap();
    assert_eq!(smaller.canonical(), [1.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.25]);
    let wrong = canonical(word::LINE, Some(&circle), &args(&fields), &context);
    assert!(matches!(
        wrong,
        Err(DefineError::NoForm { fault, .. }) if matches!(*fault, Fault::OtherKind { .. })
    ));
}

#[test]
fn a_polyconic_comes_from_its_79_elements() {
    let with_matrix = |rows: [f64; 12]| {
        let element = |i: usize| rows.get(i.wrapping_sub(1)).copied().unwrap_or(i as f64 * 0.01);
        let elements: Vec<Value> = (0..79).map(|i| n(element(i))).collect();
        canonical(word::POLCON, None, &args(&elements), &Context::default())
    };
    let quarter_turn = [0.0, -1.0, 0.0, 4.0, 1.0, 0.0, 0.0, 5.0, 0.0, 0.0, 1.0, 6.0];
    for rows in [[0.0; 12], quarter_turn] {
        let form = with_matrix(rows).unwrap();
        assert_eq!(form.kind(), FormKind::Polcon);
        assert_eq!(form.canonical().len(), 79);
        assert_eq!(form.canonical()[1..13], rows);
    }
    let one_flat = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let one_long = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    for rows in [one_flat, one_long] {
        let refused = with_matrix(rows);
        assert!(matches!(
            refused,
            Err(DefineError::NoForm { fault, .. }) if matches!(*fault, Fault::NoCurve { .. })
        ));
    }
    assert!(define(word::POLCON, &[n(1.0)]).is_err());
}
