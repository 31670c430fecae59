//! From a program to what its picture shows: the last name is the result, all others are given.

use std::collections::BTreeSet;
use std::sync::Arc;

use aptc_control::{Memory, Named, Options, Source, Verify};
use aptc_geometry::{Form, Vec3};

use super::motion::Path;

/// A named form and where it is drawn when it has no place of its own.
pub(crate) struct Item {
    /// Its name.
    pub(crate) name: String,
    /// What it is.
    pub(crate) form: Arc<Form>,
    /// Foot of a vector.
    pub(crate) foot: Vec3,
    /// The way of a tool, in place of the form.
    pub(crate) path: Option<Path>,
}

/// What a picture shows.
pub(crate) struct Scene {
    /// All names but the last, in the order of definition.
    pub(crate) given: Vec<Item>,
    /// The last name.
    pub(crate) result: Item,
    /// What other modifiers in the last statement would have given.
    pub(crate) others: Vec<Arc<Form>>,
}

/// Words that choose among several answers: each may stand for the others of its set.
const CHOICES: [&[&str]; 8] = [
    &["XLARGE", "XSMALL", "YLARGE", "YSMALL"],
    &["ZLARGE", "ZSMALL"],
    &["LEFT", "RIGHT"],
    &["IN", "OUT"],
    &["LARGE", "SMALL"],
    &["POSX", "NEGX"],
    &["POSY", "NEGY"],
    &["POSZ", "NEGZ"],
];

/// Programs tried for the answers of other modifiers.
const MOST_VARIANTS: usize = 128;

impl Scene {
    /// The scene of a program, or its messages.
    pub(crate) fn of(program: &str) -> Result<Self, String> {
        let forms = forms(program)?;
        let last = last_name(program).ok_or("the program defines nothing")?;
        let (mut given, mut result) = (Vec::new(), None);
        for (name, form) in &forms {
            let item = Item {
                name: name.clone(),
                form: form.clone(),
                foot: foot(program, name, &forms),
                path: None,
            };
            if *name == last { result = Some(item) } else { given.push(item) }
        }
        let result = result.ok_or(format!("{last} is not geometry"))?;
        let mut others: Vec<Arc<Form>> = Vec::new();
        let pattern = matches!(result.form.shape(), Form::Pattern(_) | Form::Solid(_));
        for variant in if pattern { Vec::new() } else { variants(program, &last) } {
            let Ok(forms) = self::forms(&variant) else { continue };
            let Some((_, form)) = forms.into_iter().find(|(name, _)| *name == last) else {
                continue;
            };
            if !others.iter().chain([&result.form]).any(|known| alike(known, &form)) {
                others.push(form);
            }
        }
        Ok(Self { given, result, others })
    }

    /// Everything with a name, the result last.
    pub(crate) fn items(&self) -> impl Iterator<Item = &Item> {
        self.given.iter().chain([&self.result])
    }
}

/// The named forms of a program at its end.
fn forms(program: &str) -> Result<Vec<(String, Arc<Form>)>, String> {
    let source = Source { name: "picture.apt".into(), text: program.into() };
    let options = Options { motion: false, post: false, verify: Verify::Off, ..Options::default() };
    let compiled = aptc_control::compile(source, &mut Memory::default(), &options);
    if compiled.has_errors() {
        let told: Vec<_> = compiled.diagnostics.iter().map(|d| d.message.clone()).collect();
        return Err(told.join("; "));
    }
    let form = |(name, value)| match value {
        Named::Form(form) => Some((name, form)),
        Named::Scalar(_) => None,
    };
    Ok(compiled.geometry.into_iter().filter_map(form).collect())
}

/// The name and the rest of a line that defines one.
fn definition(line: &str) -> Option<(&str, &str)> {
    let (name, rest) = line.split_once('=')?;
    let name = name.trim();
    let plain = |c: char| c.is_ascii_alphanumeric() || "()".contains(c);
    (!name.is_empty() && name.chars().all(plain)).then_some((name, rest))
}

fn last_name(program: &str) -> Option<String> {
    program.lines().rev().find_map(definition).map(|(name, _)| name.to_owned())
}

/// A vector has no place. It is drawn from the first point of its own statement, else from where the first
/// vector there is drawn, else from the point that the same arguments define, else from the first point of
/// the first statement that takes it, else from the origin.
fn foot(program: &str, name: &str, forms: &[(String, Arc<Form>)]) -> Vec3 {
    let find = |word: &str| forms.iter().find(|(n, _)| n == word).map(|(_, form)| form.shape());
    let point = |word: &str| match find(word) {
        Some(Form::Point(p)) => Some(*p),
        _ => None,
    };
    let words = |text: &str| -> Vec<String> {
        text.split(|c: char| !c.is_ascii_alphanumeric()).map(str::to_owned).collect()
    };
    let definitions = || program.lines().filter_map(definition);
    let Some((_, own)) = definitions().find(|(n, _)| *n == name) else { return Vec3::zeros() };
    if let Some(p) = words(own).iter().find_map(|w| point(w)) {
        return p;
    }
    let vector = |w: &String| matches!(find(w), Some(Form::Vector(_))) && w != name;
    if let Some(first) = words(own).into_iter().find(vector) {
        return foot(program, &first, forms);
    }
    let arguments = own.split_once('/').map_or("", |(_, a)| a);
    let same = |rest: &str| {
        rest.split_once('/').is_some_and(|(word, a)| {
            word.trim() == "POINT" && arguments.starts_with(&format!("{a},"))
        })
    };
    let beside = definitions().find(|(_, rest)| same(rest)).and_then(|(n, _)| point(n));
    let used = || {
        definitions().find_map(|(_, rest)| {
            let words = words(rest);
            let takes = words.iter().any(|w| w == name);
            if takes { words.iter().find_map(|w| point(w)) } else { None }
        })
    };
    beside.or_else(used).unwrap_or_default()
}

/// The program with each other choice of the modifiers of its last definition.
fn variants(program: &str, last: &str) -> Vec<String> {
    let start = program.lines().rev().find(|line| definition(line).is_some_and(|(n, _)| n == last));
    let Some(at) = start.and_then(|line| program.rfind(line)) else { return Vec::new() };
    let (before, statement) = program.split_at(at);
    let mut all = vec![String::new()];
    for token in statement.split_inclusive(|c: char| !c.is_ascii_alphanumeric()) {
        let word = token.trim_end_matches(|c: char| !c.is_ascii_alphanumeric());
        let tail = &token[word.len()..];
        let choices = CHOICES.into_iter().find(|set| set.contains(&word));
        let choices = choices.map_or(vec![word], <[&str]>::to_vec);
        all = all
            .iter()
            .flat_map(|text| choices.iter().map(move |w| format!("{text}{w}{tail}")))
            .take(MOST_VARIANTS)
            .collect();
    }
    let unique: BTreeSet<String> = all.into_iter().map(|text| format!("{before}{text}")).collect();
    unique.into_iter().filter(|text| text != program).collect()
}

fn alike(a: &Form, b: &Form) -> bool {
    let (one, other) = (a.canonical(), b.canonical());
    let near = |sign: f64| one.iter().zip(&other).all(|(x, y)| (x - sign * y).abs() < 1e-6);
    let turned = matches!(a.shape(), Form::Line(_) | Form::Plane(_)) && near(-1.0);
    one.len() == other.len() && (near(1.0) || turned)
}
