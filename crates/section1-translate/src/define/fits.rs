//! Sculptured curves and surfaces, each definition fitted once as long as it is among those that were asked for last.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::sync::Arc;

use aptc_geometry::sculpt::{FitFault, Sculptured, SpaceCurve, fit_curve, fit_surface};
use aptc_geometry::sculptured::{CurveDefinition, SurfaceDefinition};

/// Of each so many are kept: more than a program asks in turn.
const KEPT: usize = 32;

/// The curves and surfaces that were asked for last.
#[derive(Clone, Debug, Default)]
pub struct Fits {
    curves: Last<CurveDefinition, SpaceCurve>,
    surfaces: Last<SurfaceDefinition, Sculptured>,
}

/// Definitions with what they are, the last one in front. A definition that is kept stays where it is, so that its place tells it.
type Last<D, F> = RefCell<VecDeque<(Arc<D>, Arc<F>)>>;

impl Fits {
    /// The curve of a definition.
    ///
    /// # Errors
    /// It cannot be fitted.
    pub fn curve(&self, d: &Arc<CurveDefinition>) -> Result<Arc<SpaceCurve>, FitFault> {
        fitted(&self.curves, d, fit_curve)
    }

    /// The surface of a definition.
    ///
    /// # Errors
    /// It cannot be fitted.
    pub fn surface(&self, d: &Arc<SurfaceDefinition>) -> Result<Arc<Sculptured>, FitFault> {
        fitted(&self.surfaces, d, fit_surface)
    }
}

fn fitted<D, F>(
    last: &Last<D, F>,
    d: &Arc<D>,
    fit: impl Fn(&D) -> Result<F, FitFault>,
) -> Result<Arc<F>, FitFault> {
    let mut last = last.borrow_mut();
    if let Some(at) = last.iter().position(|(known, _)| Arc::ptr_eq(known, d)) {
        last.make_contiguous()[..=at].rotate_right(1);
    } else {
        let new = Arc::new(fit(d)?);
        last.truncate(KEPT - 1);
        last.push_front((Arc::clone(d), new));
    }
    Ok(Arc::clone(&last[0].1))
}

#[cfg(test)]
mod tests {
    use aptc_geometry::Vec3;
    use aptc_geometry::sculptured::CurveShape;

    use super::*;

    fn line(x: f64) -> Arc<CurveDefinition> {
        let ends = [Vec3::zeros(), Vec3::new(x, 0.0, 0.0)];
        Arc::new(CurveDefinition::plain(CurveShape::Stretch { ends }))
    }

    #[test]
    fn a_definition_is_fitted_once_and_what_is_kept_has_a_bound() {
        let fits = Fits::default();
        let first = line(1.0);
        let fitted = fits.curve(&first).unwrap();
        for x in 2..=KEPT {
            assert!(fits.curve(&line(x as f64)).is_ok());
            assert!(Arc::ptr_eq(&fits.curve(&first).unwrap(), &fitted));
        }
        assert!(fits.curve(&line(0.0)).is_err());
        assert_eq!(fits.curves.borrow().len(), KEPT);
        for x in 1..=KEPT {
            assert!(fits.curve(&line(x as f64)).is_ok());
        }
        assert_eq!(fits.curves.borrow().len(), KEPT);
        let again = fits.curve(&first).unwrap();
        assert!(!Arc::ptr_eq(&again, &fitted) && again == fitted);
    }
}
