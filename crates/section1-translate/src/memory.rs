//! Where values are kept: names of the program, elements of arrays, parameters of macro calls.

use std::sync::Arc;

use aptc_diagnostics::Span;
use aptc_geometry::Form;
use aptc_syntax::Symbol;
use aptc_vocabulary::Word;

/// What a name stands for.
#[derive(Clone, Debug, Default)]
pub(crate) enum Value {
    /// Nothing yet.
    #[default]
    Unset,
    /// A number.
    Number(f64),
    /// `.TRUE.` or `.FALSE.`
    Logical(bool),
    /// A geometric form, in the base system.
    Form(Arc<Form>),
    /// A vocabulary word: the actual value of a macro parameter.
    Word(Word),
    /// An array by RESERV.
    Array(u32),
    /// A mistake was reported where it should have got its value.
    Poison,
}

/// A value and the place where it was given.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slot {
    /// The value.
    pub(crate) value: Value,
    /// Where it was given.
    pub(crate) given: Span,
    /// Was it used?
    pub(crate) read: bool,
}

/// Where a slot is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// A name of the program.
    Global(Symbol),
    /// An element of an array, from 0.
    Element(u32, u32),
    /// A parameter or LOCAL name of a macro call.
    Local(u32),
}

/// A parameter or LOCAL name.
#[derive(Clone, Debug)]
pub(crate) struct Local {
    /// Its name.
    pub(crate) symbol: Symbol,
    /// What it stands for.
    pub(crate) binding: Binding,
    /// When its own value last changed.
    changed: u64,
}

/// What a parameter stands for.
#[derive(Clone, Debug)]
pub(crate) enum Binding {
    /// A value of its own.
    Own(Slot),
    /// Another name, which the macro may also give a value.
    Alias(Place),
}

/// An array.
#[derive(Clone, Debug)]
pub(crate) struct Array {
    /// Its name.
    pub(crate) symbol: Symbol,
    /// Its elements.
    pub(crate) slots: Vec<Slot>,
    /// A subscript was wrong where an element should have got its value: none is missed.
    pub(crate) doubtful: bool,
}

/// Are two values the same, to the last bit?
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.to_bits() == b.to_bits(),
        (Value::Logical(a), Value::Logical(b)) => a == b,
        (Value::Form(a), Value::Form(b)) => Arc::ptr_eq(a, b) || a == b,
        (Value::Word(a), Value::Word(b)) => a == b,
        (Value::Array(a), Value::Array(b)) => a == b,
        (Value::Unset, Value::Unset) | (Value::Poison, Value::Poison) => true,
        _ => false,
    }
}

/// All values of a run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    globals: Vec<Slot>,
    arrays: Vec<Array>,
    locals: Vec<Local>,
    /// For each symbol its place in `locals` and 1, or 0 when it is no local of the present call.
    bound: Vec<u32>,
    /// Names with a number or a form in the order in which they first got one.
    order: Vec<Place>,
    n_elements: usize,
    /// Counts changes of values.
    clock: u64,
    /// When a value that outlives the present call last changed.
    changed: u64,
}

impl Memory {
    /// Makes room for `n` symbols.
    pub(crate) fn grow(&mut self, n: usize) {
        if self.globals.len() < n {
            self.globals.resize_with(n, Slot::default);
            self.bound.resize(n, 0);
        }
    }

    /// Forgets everything but the room.
    pub(crate) fn clear(&mut self) {
        let n = self.globals.len();
        *self = Self::default();
        self.grow(n);
    }

    /// Where the value of `symbol` is, seen from the present call.
    pub(crate) fn place(&self, symbol: Symbol) -> Place {
        match self.bound.get(symbol.0 as usize) {
            None | Some(0) => Place::Global(symbol),
            Some(&local) => match &self.locals[local as usize - 1].binding {
                Binding::Own(_) => Place::Local(local - 1),
                Binding::Alias(place) => *place,
            },
        }
    }

    /// Is it a parameter or LOCAL name of the present call?
    pub(crate) fn is_local(&self, symbol: Symbol) -> bool {
        self.bound.get(symbol.0 as usize).is_some_and(|b| *b != 0)
    }

    /// What is at `place`.
    pub(crate) fn slot(&self, place: Place) -> &Slot {
        match place {
            Place::Global(symbol) => &self.globals[symbol.0 as usize],
            Place::Element(array, i) => &self.arrays[array as usize].slots[i as usize],
            Place::Local(i) => match &self.locals[i as usize].binding {
                Binding::Own(slot) => slot,
                Binding::Alias(place) => self.slot(*place),
            },
        }
    }

    /// What is at `place`, to change it.
    pub(crate) fn slot_mut(&mut self, place: Place) -> &mut Slot {
        match place {
            Place::Global(symbol) => &mut self.globals[symbol.0 as usize],
            Place::Element(array, i) => &mut self.arrays[array as usize].slots[i as usize],
            Place::Local(i) => {
                if let Binding::Alias(place) = self.locals[i as usize].binding {
                    return self.slot_mut(place);
                }
                match &mut self.locals[i as usize].binding {
                    Binding::Own(slot) => slot,
                    Binding::Alias(_) => unreachable!("aliases were followed above"),
                }
            }
        }
    }

    /// Gives `place` a value.
    pub(crate) fn set(&mut self, place: Place, value: Value, given: Span) {
        let slot = self.slot_mut(place);
        let first = matches!(slot.value, Value::Unset | Value::Poison)
            && matches!(value, Value::Number(_) | Value::Form(_));
        if first && !matches!(place, Place::Local(_)) {
            self.order.push(place);
        }
        if !same(&self.slot(place).value, &value) {
            self.touch(place);
        }
        let slot = self.slot_mut(place);
        slot.value = value;
        slot.given = given;
    }

    fn touch(&mut self, place: Place) {
        self.clock += 1;
        match place {
            Place::Local(i) if matches!(self.locals[i as usize].binding, Binding::Own(_)) => {
                self.locals[i as usize].changed = self.clock;
            }
            _ => self.changed = self.clock,
        }
    }

    /// Something else than a value changed that the order of execution depends on.
    pub(crate) fn stir(&mut self) {
        self.clock += 1;
        self.changed = self.clock;
    }

    /// When anything last changed that the present call can see; a value that is set again to what it was has
    /// not changed, and what calls that are over had for themselves does not count.
    pub(crate) fn last_change(&self) -> u64 {
        self.locals.iter().map(|local| local.changed).fold(self.changed, u64::max)
    }

    /// The array with number `array`.
    pub(crate) fn array(&self, array: u32) -> &Array {
        &self.arrays[array as usize]
    }

    /// An element did not get its value for a mistake that was told.
    pub(crate) fn doubt(&mut self, array: u32) {
        self.arrays[array as usize].doubtful = true;
    }

    /// A new array of `n` elements.
    pub(crate) fn reserve(&mut self, symbol: Symbol, n: usize, given: Span) {
        let array = u32::try_from(self.arrays.len()).expect("fewer arrays than elements");
        self.arrays.push(Array { symbol, slots: vec![Slot::default(); n], doubtful: false });
        self.n_elements += n;
        self.set(self.place(symbol), Value::Array(array), given);
    }

    /// Elements of all arrays.
    pub(crate) fn n_elements(&self) -> usize {
        self.n_elements
    }

    /// The name of what is at `place`: its symbol and subscript.
    pub(crate) fn name(&self, place: Place) -> (Symbol, u32) {
        match place {
            Place::Global(symbol) => (symbol, 0),
            Place::Element(array, i) => (self.arrays[array as usize].symbol, i + 1),
            Place::Local(i) => (self.locals[i as usize].symbol, 0),
        }
    }

    /// Numbers and forms of the program's names, in the order in which they first got one.
    pub(crate) fn in_order(&self) -> impl Iterator<Item = (Place, &Value)> {
        let values = self.order.iter().map(|&place| (place, &self.slot(place).value));
        values.filter(|(_, value)| matches!(value, Value::Number(_) | Value::Form(_)))
    }

    /// All names and elements that have a value, in the order of their first appearance in the text.
    pub(crate) fn values(&self) -> impl Iterator<Item = (Place, &Slot)> {
        let symbols = (0u32..).zip(&self.globals);
        symbols.flat_map(move |(i, slot)| {
            let own = (Place::Global(Symbol(i)), slot);
            let elements = match slot.value {
                Value::Array(a) => {
                    let slots = self.arrays[a as usize].slots.iter();
                    Some((0u32..).zip(slots).map(move |(i, s)| (Place::Element(a, i), s)))
                }
                _ => None,
            };
            std::iter::once(own).chain(elements.into_iter().flatten())
        })
    }

    /// How many parameters and LOCAL names there are in all calls.
    pub(crate) fn n_locals(&self) -> usize {
        self.locals.len()
    }

    /// Hides the locals from `from` on: they belong to the caller.
    pub(crate) fn hide(&mut self, from: usize) {
        for local in &self.locals[from..] {
            self.bound[local.symbol.0 as usize] = 0;
        }
    }

    /// A local of the present call.
    pub(crate) fn bind(&mut self, symbol: Symbol, binding: Binding) {
        self.locals.push(Local { symbol, binding, changed: 0 });
        let place = u32::try_from(self.locals.len()).expect("fewer locals than statements");
        self.bound[symbol.0 as usize] = place;
    }

    /// Drops the locals from `from` on and shows those of the caller, from `caller` on, again.
    pub(crate) fn unbind(&mut self, from: usize, caller: usize) {
        self.hide(from);
        self.locals.truncate(from);
        for (i, local) in self.locals.iter().enumerate().skip(caller) {
            self.bound[local.symbol.0 as usize] =
                u32::try_from(i + 1).expect("fewer locals than statements");
        }
    }
}
