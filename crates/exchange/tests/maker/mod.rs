//! Files of STEP put together from numbered entities, and what is read of them.

use std::fmt::Write;

use aptc_exchange::{Fault, Limits, Outside, read};
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Sculptured, fit_surface};

/// A file of STEP that is put together from numbered entities.
#[derive(Default)]
pub(crate) struct Step(pub(crate) Vec<String>);

impl Step {
    pub(crate) fn add(&mut self, entity: String) -> usize {
        self.0.push(entity);
        self.0.len()
    }

    pub(crate) fn point(&mut self, [x, y, z]: [f64; 3]) -> usize {
        self.add(format!("CARTESIAN_POINT('',({},{},{}))", real(x), real(y), real(z)))
    }

    pub(crate) fn direction(&mut self, [x, y, z]: [f64; 3]) -> usize {
        self.add(format!("DIRECTION('',({},{},{}))", real(x), real(y), real(z)))
    }

    pub(crate) fn frame(&mut self, at: [f64; 3], z: [f64; 3], x: [f64; 3]) -> usize {
        let (p, z, x) = (self.point(at), self.direction(z), self.direction(x));
        self.add(format!("AXIS2_PLACEMENT_3D('',#{p},#{z},#{x})"))
    }

    pub(crate) fn vertex(&mut self, at: [f64; 3]) -> usize {
        let p = self.point(at);
        self.add(format!("VERTEX_POINT('',#{p})"))
    }

    pub(crate) fn line(&mut self, from: [f64; 3], to: [f64; 3]) -> usize {
        let d = [0, 1, 2].map(|i| to[i] - from[i]);
        let (p, d) = (self.point(from), self.direction(d));
        let v = self.add(format!("VECTOR('',#{d},1.)"));
        self.add(format!("LINE('',#{p},#{v})"))
    }

    pub(crate) fn circle(&mut self, at: [f64; 3], z: [f64; 3], x: [f64; 3], r: f64) -> usize {
        let frame = self.frame(at, z, x);
        self.add(format!("CIRCLE('',#{frame},{r:?})"))
    }

    /// An edge along a curve, `along` its sense.
    pub(crate) fn edge(&mut self, ends: [usize; 2], curve: usize, along: bool) -> usize {
        let [a, b] = ends;
        self.add(format!("EDGE_CURVE('',#{a},#{b},#{curve},{})", flag(along)))
    }

    /// A loop of edges, each with its sense.
    pub(crate) fn bound(&mut self, edges: &[(usize, bool)]) -> usize {
        let all: Vec<String> = edges
            .iter()
            .map(|(e, along)| {
                let id = self.add(format!("ORIENTED_EDGE('',*,*,#{e},{})", flag(*along)));
                format!("#{id}")
            })
            .collect();
        let id = self.add(format!("EDGE_LOOP('',({}))", all.join(",")));
        self.add(format!("FACE_BOUND('',#{id},.T.)"))
    }

    pub(crate) fn face(&mut self, bounds: &[usize], surface: usize) -> usize {
        let all: Vec<String> = bounds.iter().map(|b| format!("#{b}")).collect();
        self.add(format!("ADVANCED_FACE('',({}),#{surface},.T.)", all.join(",")))
    }

    /// Straight edges around corners.
    pub(crate) fn polygon(&mut self, corners: &[[f64; 3]]) -> usize {
        let vertices: Vec<usize> = corners.iter().map(|p| self.vertex(*p)).collect();
        let edges: Vec<_> = (0..corners.len())
            .map(|k| {
                let j = (k + 1) % corners.len();
                let line = self.line(corners[k], corners[j]);
                (self.edge([vertices[k], vertices[j]], line, true), true)
            })
            .collect();
        self.bound(&edges)
    }

    pub(crate) fn read(&self) -> Outside {
        self.tried().expect("surfaces")
    }

    pub(crate) fn tried(&self) -> Result<Outside, Fault> {
        self.within(&Limits::default())
    }

    pub(crate) fn within(&self, limits: &Limits) -> Result<Outside, Fault> {
        let mut data = String::new();
        for (k, entity) in self.0.iter().enumerate() {
            writeln!(data, "#{}={entity};", k + 1).expect("a string");
        }
        if !data.contains("UNIT_ASSIGNED") {
            let n = self.0.len();
            let context = format!("GLOBAL_UNIT_ASSIGNED_CONTEXT((#{}))", n + 1);
            let unit = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";
            write!(
                data,
                "#{}={unit};\n#{}=({context}REPRESENTATION_CONTEXT('',''));\n",
                n + 1,
                n + 2
            )
            .expect("a string");
        }
        let text = format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','b',(''),(''),'c','d','');\n\
             FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n{data}ENDSEC;\nEND-ISO-10303-21;\n"
        );
        read(&text, limits).expect("STEP")
    }
}

/// A number with the point that STEP asks for.
fn real(x: f64) -> String {
    let text = format!("{x:?}");
    match text.split_once('e') {
        Some((digits, power)) if !digits.contains('.') => format!("{digits}.E{power}"),
        _ => text.to_uppercase(),
    }
}

fn flag(b: bool) -> &'static str {
    if b { ".T." } else { ".F." }
}

/// Places all over the first surface, its corners among them.
pub(crate) fn places(file: &Outside) -> Vec<Vec3> {
    let s: Sculptured = fit_surface(&file.surfaces[0]).expect("a surface");
    let [nu, nv] = s.spans();
    let share = |k: i32| f64::from(k) / 12.0;
    (0..=12)
        .flat_map(|i| (0..=12).map(move |j| (i, j)))
        .map(|(i, j)| s.at(nu * share(i), nv * share(j)).point)
        .collect()
}

/// Least and greatest coordinates.
pub(crate) fn bounds(all: &[Vec3]) -> [Vec3; 2] {
    all.iter().fold([all[0], all[0]], |b, p| [b[0].inf(p), b[1].sup(p)])
}

pub(crate) fn near(a: Vec3, b: [f64; 3]) -> bool {
    (a - Vec3::from(b)).norm() < 1e-9
}
