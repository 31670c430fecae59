//! Principal directions of a symmetric matrix.

use nalgebra::Matrix3;

use crate::Vec3;

/// Eigenvectors (columns) and eigenvalues of a symmetric matrix by Jacobi's rotations. A diagonal matrix
/// comes back untouched.
pub(super) fn eigen(mut m: Matrix3<f64>) -> (Matrix3<f64>, Vec3) {
    let mut v = Matrix3::identity();
    // Convergence is quadratic: five sweeps do for doubles, the bound is never met.
    for _ in 0..30 {
        let off = m[(0, 1)].abs() + m[(0, 2)].abs() + m[(1, 2)].abs();
        if off <= f64::EPSILON * f64::EPSILON * m.amax() {
            break;
        }
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let e = m[(i, j)];
            if e == 0.0 {
                continue;
            }
            let theta = (m[(j, j)] - m[(i, i)]) / (2.0 * e);
            let t = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            let mut r = Matrix3::identity();
            r[(i, i)] = c;
            r[(j, j)] = c;
            r[(i, j)] = s;
            r[(j, i)] = -s;
            m = r.transpose() * m * r;
            m[(i, j)] = 0.0;
            m[(j, i)] = 0.0;
            v *= r;
        }
    }
    (v, m.diagonal())
}
