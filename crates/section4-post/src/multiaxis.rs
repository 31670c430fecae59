//! Motion with rotary axes: straight paths of the tool end, winding back.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord, MotionCode};
use crate::motion::ALL;
use crate::pose::Pose;
use crate::post::{Post, trimmed};
use crate::turnmill::RAPID_BAND_MM;

/// How often a motion may be halved: 4096 blocks of one motion at most.
const MOST_HALVINGS: u32 = 12;

/// How often a free axis may jump within one motion; beyond it the rotary axes are wound back.
const MOST_TURNS: u32 = 16;

/// How far above the top of the stock the tool end is while rotary axes turn over, millimetres.
const CLEAR_OF_STOCK_MM: f64 = 2.0;

impl Post {
    /// Switches tool-centre control on where it has a line of its own.
    pub(crate) fn tool_center_on(&mut self) {
        let m = &self.machine.multiaxis;
        if !m.tool_center || m.tool_center_with_z || self.st.centered || self.st.plane.is_some() {
            return;
        }
        let offset = self.st.offset.map_or(String::new(), |o| o.to_string());
        if let Some(line) = crate::emit::render(&m.tool_center_on, &[("offset", &offset)]) {
            self.blocks.line(&line);
        }
        self.st.centered = true;
    }

    /// Ends tool-centre control that has a line of its own: the lines of the machine file go to places of the machine.
    pub(crate) fn tool_center_off(&mut self) {
        if std::mem::take(&mut self.st.centered) {
            let machine = std::sync::Arc::clone(&self.machine);
            self.blocks.line(&machine.multiaxis.tool_center_off);
        }
    }

    /// One straight motion of the tool end while rotary axes may turn.
    pub(crate) fn go_turning(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        let Some(end) = self.pose(te, ta, self.st.angles, origin) else { return };
        let total = self.distance(te);
        let Some(pos) = self.st.pos else {
            self.leg(&end, rapid, total, origin);
            return;
        };
        // The place of the axes is known from the last block unless the tool end came otherwise.
        let start = match self.st.placed {
            Some((te, xyz)) if te == pos => {
                Pose { te: pos, ta: self.st.ta, angles: self.st.angles, xyz }
            }
            _ => self.placed(pos, self.st.ta, self.st.angles),
        };
        // Halves still to do, the next one last.
        let mut from = start;
        if self.straight_enough(&from, &end, rapid) || rapid && self.free_to_turn(pos, te) {
            self.leg(&end, rapid, total, origin);
            return;
        }
        let end = match self.turn_free(&mut from, &end, 1.0, rapid, origin) {
            None => return,
            Some(false) => end,
            Some(true) => match self.pose(te, ta, from.angles, origin) {
                Some(end) => end,
                None => return,
            },
        };
        let mut to_do = vec![(end, 0)];
        let mut turns = 0;
        while let Some((to, halved)) = to_do.pop() {
            if self.straight_enough(&from, &to, rapid) {
                let part = (to.te - from.te).norm();
                if !self.leg(&to, rapid, part, origin) {
                    return;
                }
                from = to;
                continue;
            }
            if halved >= MOST_HALVINGS {
                // A free axis jumps: it turns while the tool stays in its place.
                let turned = if turns < MOST_TURNS {
                    self.turn_free(&mut from, &to, 3.0, rapid, origin)
                } else {
                    Some(false)
                };
                turns += 1;
                match turned {
                    None => return,
                    Some(true) => to_do.push((to, 0)),
                    Some(false) => {
                        if !self.wind_back(&from, &to, rapid, origin) {
                            return;
                        }
                        from = to;
                    }
                }
                continue;
            }
            let middle = (from.ta + to.ta) / 2.0;
            if middle.norm() < 1e-3 {
                let message = "the tool axis turns over between two positions".to_string();
                let help = "put positions between them that say which way it turns";
                let code = codes::AXIS_OUT_OF_REACH;
                self.error_counted(code, "turns over", origin, message, help);
                return;
            }
            let te = (from.te + to.te) / 2.0;
            let Some(half) = self.pose(te, middle.normalize(), from.angles, origin) else { return };
            // The end again, now near to the half.
            let Some(again) = self.pose(to.te, to.ta, half.angles, origin) else { return };
            to_do.push((again, halved + 1));
            to_do.push((half, halved + 1));
        }
    }

    /// In the singular direction one rotary axis is free: it goes to where the motion needs it while the tool
    /// stays in its place. Did it have to? `None` after a refusal.
    fn turn_free(
        &mut self,
        from: &mut Pose,
        to: &Pose,
        cone: f64,
        rapid: bool,
        origin: &Origin,
    ) -> Option<bool> {
        let free = self.st.chain.as_ref().and_then(|c| c.free(from.te, from.ta, cone));
        let Some(i) = free.filter(|&i| (to.angles[i] - from.angles[i]).abs() > 1e-9) else {
            return Some(false);
        };
        let way = to.angles[i] - from.angles[i];
        let turned = |angle: f64| {
            let mut angles = from.angles;
            angles[i] += angle;
            self.placed(from.te, from.ta, self.blocks.round_angles(angles))
        };
        let mut n: u32 = 1;
        let short = |n: u32| self.straight_enough(from, &turned(way / f64::from(n)), rapid);
        while n < 1 << MOST_HALVINGS && !short(n) {
            n *= 2;
        }
        let legs: Vec<Pose> = (1..=n).map(|k| turned(way * f64::from(k) / f64::from(n))).collect();
        for pose in legs {
            if !self.leg(&pose, rapid, 0.0, origin) {
                return None;
            }
            *from = pose;
        }
        Some(true)
    }

    /// Does the tool follow closely enough when all axes move evenly from one pose to the other?
    fn straight_enough(&self, from: &Pose, to: &Pose, rapid: bool) -> bool {
        #[expect(clippy::float_cmp, reason = "rounded numbers: the same text")]
        if from.angles == to.angles {
            return true;
        }
        let Some(chain) = &self.st.chain else { return true };
        let lintol = match self.machine.is_milling() && rapid {
            true => self.lintol().max(RAPID_BAND_MM / self.st.out_mm()),
            false => self.lintol(),
        };
        let lean = self.machine.multiaxis.axis_tolerance.to_radians();
        let (a, b) = (from.joints(), to.joints());
        // The tool end is turned by the angles x while the axes move by d: from its second derivative
        // x^2 r + 2 x d it cannot leave the line by more than an eighth of that.
        let x = (0..2).map(|i| (b[3 + i] - a[3 + i]).abs()).sum::<f64>().to_radians();
        let r = chain.reach() + from.xyz.norm().max(to.xyz.norm());
        if x < 2.0 * lean && x * (x * r + 2.0 * (to.xyz - from.xyz).norm()) <= 8.0 * lintol {
            return true;
        }
        [0.5, 0.25, 0.75].into_iter().all(|s| {
            let mut joints = [0.0; 5];
            for i in 0..5 {
                joints[i] = a[i] + (b[i] - a[i]) * s;
            }
            let (te, ta) = chain.forward(&joints);
            let line = to.te - from.te;
            let length2 = line.norm_squared();
            let along = if length2 > 0.0 { (te - from.te).dot(&line) / length2 } else { 0.0 };
            let foot = from.te + line * along.clamp(0.0, 1.0);
            let normal = from.ta.cross(&to.ta);
            let out = if normal.norm() > 1e-9 {
                aptc_geometry::trig::asin(ta.dot(&normal.normalize()).clamp(-1.0, 1.0)).abs()
            } else {
                (ta - from.ta).norm()
            };
            (te - foot).norm() <= lintol && out <= lean
        })
    }

    /// One block, or one rapid motion.
    fn leg(&mut self, to: &Pose, rapid: bool, length: f64, origin: &Origin) -> bool {
        let joints = to.joints();
        self.reach(&joints, origin);
        if rapid {
            self.rapid_to(to.te, &joints, origin);
        } else {
            let Some(feed) = self.turning_feed(to, length, origin) else { return false };
            let done = self.blocks.straight(MotionCode::Line, &joints, ALL, Some(feed));
            self.check(done, origin);
            self.count_cut(to.te, length, feed);
            self.takes_away(self.st.pos, to.te, to.ta, origin);
        }
        self.st.pos = Some(to.te);
        self.st.ta = to.ta;
        self.st.angles = to.angles;
        self.st.placed = Some((to.te, to.xyz));
        true
    }

    /// LINTOL or that of the machine, in output units.
    pub(crate) fn lintol(&self) -> f64 {
        self.st.lintol_mm.unwrap_or(self.machine.multiaxis.lintol) / self.st.out_mm()
    }

    /// How far the tool goes up along itself before the rotary axes turn over: at least `least`, to the clearance plane,
    /// and above the top of the stock, where these do not lie steep to it.
    fn clear_of(&self, at: &Pose, least: f64) -> f64 {
        let plane = self.height_of_clearance(at.te, at.ta).unwrap_or(0.0);
        let top = self.summary.stock.filter(|_| at.ta.z > 0.1).map_or(0.0, |[_, max]| {
            let above = CLEAR_OF_STOCK_MM / self.st.out_mm();
            (max[2] + above - at.te.z) / at.ta.z
        });
        least.max(plane).max(top)
    }

    /// The rotary axes go over to another pair of angles while the tool is away from the part.
    fn wind_back(&mut self, from: &Pose, to: &Pose, rapid: bool, origin: &Origin) -> bool {
        let m = &self.machine.multiaxis;
        let unit = self.st.out_mm();
        let (retract, feed) = (m.rewind_retract / unit, m.rewind_feed / unit);
        if retract <= 0.0 {
            let message = format!(
                "the rotary axes of {} would have to turn over within a motion",
                self.machine.name
            );
            let help = "split the motion, lay the part otherwise, or allow it with \
                        `multiaxis.rewind_retract` in the machine file";
            self.error(codes::WIND_BACK, origin, message, help);
            return false;
        }
        let retract = self.clear_of(from, retract).max(self.clear_of(to, retract));
        let message = format!(
            "the rotary axes are wound back with the tool retracted by {}",
            trimmed(retract, 3)
        );
        self.warn(codes::WIND_BACK, origin, message, "look at this place before cutting");
        let cut = FeedWord { mode: FeedMode::PerMinute, value: feed };
        let up = self.placed(from.te + from.ta * retract, from.ta, from.angles);
        let over = self.placed(to.te + to.ta * retract, to.ta, to.angles);
        for (pose, rapid) in [(up, rapid), (over, true), (*to, rapid)] {
            let joints = pose.joints();
            self.reach(&joints, origin);
            let done = if rapid {
                self.blocks.straight(MotionCode::Rapid, &joints, ALL, None)
            } else {
                self.blocks.straight(MotionCode::Line, &joints, ALL, Some(cut))
            };
            self.check(done, origin);
            self.count_rapid(pose.te);
            self.st.pos = Some(pose.te);
        }
        self.st.ta = to.ta;
        self.st.angles = to.angles;
        self.st.placed = None;
        true
    }
}
