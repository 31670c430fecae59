//! What a machine file need not say: the words that nearly all RS-274 controls share.

use std::collections::BTreeMap;

use super::{
    ArcCenter, ArcPlane, Arcs, BlockNumbers, Compensation, CycleWords, Feed, Multiaxis, Program,
    Rapid, RapidPath, RotaryFeed, Spindle,
};

impl Default for Program {
    fn default() -> Self {
        Self {
            start: Vec::new(),
            end: vec!["M30".into()],
            tool_change: vec!["T{tool} M6".into()],
            preselect: "T{next}".into(),
            retract: Vec::new(),
            home: Vec::new(),
            start_retracts: false,
            stop: "M0".into(),
            optional_stop: "M1".into(),
            dwell: "G4 P{seconds}".into(),
            inch: "G20".into(),
            metric: "G21".into(),
            work_offset: String::new(),
            path_tolerance: 0.0,
            path_mode: String::new(),
            number: 0,
            separator: " ".into(),
            comment_open: "(".into(),
            comment_close: ")".into(),
            comment_forbidden: "()".into(),
            comment_capitals: true,
            max_line: 255,
            skip: "/".into(),
            block_numbers: BlockNumbers::default(),
        }
    }
}

impl Default for BlockNumbers {
    fn default() -> Self {
        Self { on: false, letter: "N".into(), start: 10, step: 10, max: 99_999 }
    }
}

impl Default for Spindle {
    fn default() -> Self {
        Self {
            cw: "S{speed} M3".into(),
            ccw: "S{speed} M4".into(),
            off: "M5".into(),
            orient: String::new(),
            surface_speed: String::new(),
            surface_speed_off: String::new(),
            min: 0.0,
            max: 0.0,
            ranges: BTreeMap::new(),
        }
    }
}

impl Default for Feed {
    fn default() -> Self {
        Self {
            per_minute: "G94".into(),
            per_revolution: String::new(),
            inverse_time: String::new(),
            max: 0.0,
        }
    }
}

impl Default for Rapid {
    fn default() -> Self {
        Self { path: RapidPath::Straight, feed: 10_000.0 }
    }
}

impl Default for Arcs {
    fn default() -> Self {
        Self {
            planes: vec![ArcPlane::Xy, ArcPlane::Zx, ArcPlane::Yz],
            center: ArcCenter::Relative,
            helix: true,
            full_circle: true,
            max_sweep: 360.0,
            min_radius: 0.01,
            max_radius: 10_000.0,
            radius_tolerance: 0.002,
            fit: 0.0,
        }
    }
}

impl Default for CycleWords {
    fn default() -> Self {
        Self {
            off: "G80".into(),
            call: String::new(),
            to_initial: "G98".into(),
            to_clearance: "G99".into(),
            step: 'Q',
            dwell: 'P',
            dwell_ms: false,
            peck_back: 0.5,
        }
    }
}

impl Default for Compensation {
    fn default() -> Self {
        Self {
            length: "G43 H{offset}".into(),
            length_off: "G49".into(),
            retract_ends_length: false,
            left: String::new(),
            right: String::new(),
            off: "G40".into(),
            off_with_motion: false,
            wear_define: String::new(),
            wear_note: String::new(),
        }
    }
}

impl Default for Multiaxis {
    fn default() -> Self {
        Self {
            tool_center: false,
            tool_center_on: String::new(),
            tool_center_with_z: false,
            tool_center_off: String::new(),
            plane_on: Vec::new(),
            plane_off: Vec::new(),
            lintol: 0.01,
            axis_tolerance: 5.0,
            feed: RotaryFeed::Tip,
            rewind_retract: 0.0,
            rewind_feed: 1000.0,
            singular: 0.01,
            turn_note: String::new(),
            tool_length: None,
        }
    }
}
