//! One bubble over one call: radius and motion together, in substeps.
//!
//! A substep: flow here and at the place and time where the bubble will be, straight lines between them; the radius follows
//! its law along these lines, and after every step of the radius the velocity and place follow. Second order in the substep.

use super::carrier::{Carrier, CarrierError, CarrierPoint, surface_average};
use super::motion::{Leg, SlipLedger, between, kick};
use super::records::{Begin, CloudLedger, CollapseRecord, Fate};
use super::settings::Settings;
use crate::vector::{Vector, along, dot, mix, norm, scale, sub};
use erode_physics::bubble::{
    Ambient, BubbleError, BubbleState, DenseStep, Event, EventKind, Gas, Linear, Progress, Watch,
    advance,
};
use erode_physics::erosion::{Assessment, NearWallCollapse};

/// Largest change of ln R over which a velocity is kicked at once.
const RADIUS_PART: f64 = 0.05;

/// A bubble of the cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bubble {
    pub(super) id: u64,
    pub(super) position: Vector,
    pub(super) velocity: Vector,
    pub(super) state: BubbleState,
    pub(super) gas: Gas,
    pub(super) mass: f64,
    pub(super) slip_ledger: SlipLedger,
    pub(super) begin: Option<Begin>,
}

/// A bubble under way.
pub(super) struct Traveller<'a, C: ?Sized> {
    pub(super) carrier: &'a C,
    pub(super) settings: &'a Settings,
    pub(super) bubble: Bubble,
    pub(super) records: Vec<CollapseRecord>,
    pub(super) counts: CloudLedger,
    /// Flow at the ends of the substep.
    flow: [CarrierPoint; 2],
    /// Times of its ends, s.
    ends: [f64; 2],
    /// Time (s) and radius (m) up to which the velocity has followed.
    reached: (f64, f64),
    /// Time, s.
    now: f64,
}

/// Why a bubble did not arrive.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Stop {
    /// The bubble is gone.
    Gone(Fate),
    /// The flow has no answer although the bubble is in its domain.
    Flow(CarrierError),
}

impl From<CarrierError> for Stop {
    fn from(error: CarrierError) -> Self {
        match error {
            CarrierError::Outside { .. } => Self::Gone(Fate::LeftDomain),
            other => Self::Flow(other),
        }
    }
}

impl From<BubbleError> for Stop {
    fn from(error: BubbleError) -> Self {
        Self::Gone(Fate::Failed(error.to_string()))
    }
}

impl<'a, C: Carrier> Traveller<'a, C> {
    pub(super) fn new(carrier: &'a C, settings: &'a Settings, bubble: Bubble, now: f64) -> Self {
        let nowhere = CarrierPoint::at_rest(0.0, 1.0, 0.0);
        Self {
            carrier,
            settings,
            bubble,
            records: Vec::new(),
            counts: CloudLedger::default(),
            flow: [nowhere; 2],
            ends: [now; 2],
            reached: (now, bubble.state.radius),
            now,
        }
    }

    /// Goes on to a time, s.
    pub(super) fn run(&mut self, until: f64) -> Result<(), Stop> {
        let mut substeps = 0;
        while self.now < until {
            if substeps == self.settings.max_substeps {
                return Err(Stop::Gone(Fate::TooManySubsteps));
            }
            self.substep(until)?;
            substeps += 1;
        }
        Ok(())
    }

    fn substep(&mut self, until: f64) -> Result<(), Stop> {
        let start = self.now;
        let here = self.sample(self.bubble.position, start)?;
        let remaining = until - start;
        let wanted = self.length(&here);
        // No sliver at the end: the rest is shared out evenly.
        let parts = (remaining / wanted).ceil().max(1.0);
        let end = if parts == 1.0 {
            until
        } else {
            start + remaining / parts
        };
        if end <= start {
            return Err(Stop::Gone(Fate::TooManySubsteps));
        }
        let mut ahead = along(self.bubble.position, end - start, self.bubble.velocity);
        self.hold(&mut ahead, None);
        let there = self.sample(ahead, end)?;
        self.flow = [here, there];
        self.ends = [start, end];
        self.reached = (start, self.bubble.state.radius);
        self.counts.substeps += 1;
        self.follow(end)?;
        self.now = end;
        Ok(())
    }

    /// Radius and motion over the substep.
    fn follow(&mut self, end: f64) -> Result<(), Stop> {
        let Some(model) = self.settings.dynamics else {
            let radius = self.bubble.state.radius;
            self.travel(end, radius);
            self.bubble.state.time = end;
            return Ok(());
        };
        let driving = self.driving();
        // The watcher moves the bubble while the integrator holds its state.
        let (mut state, gas) = (self.bubble.state, self.bubble.gas);
        let (liquid, controls) = (&self.settings.liquid, &self.settings.controls);
        let result = advance(
            &model, liquid, &gas, &driving, controls, &mut state, end, self,
        );
        self.bubble.state = state;
        match result? {
            Progress::Closed => Err(Stop::Gone(Fate::Closed)),
            Progress::Reached => {
                self.travel(end, state.radius);
                Ok(())
            }
        }
    }

    /// Pressure and slip along the substep.
    fn driving(&self) -> Linear {
        let [start_time, end_time] = self.ends;
        let (radius, rate) = (self.bubble.state.radius, self.bubble.state.wall_velocity);
        let ahead = radius + rate * (end_time - start_time);
        let leg = Leg {
            flow: self.flow,
            radius: [radius, ahead.clamp(0.5 * radius, 2.0 * radius)],
            duration: end_time - start_time,
        };
        let velocity = self.bubble.velocity;
        let end = kick(&self.settings.forces, self.bubble.mass, velocity, &leg).velocity;
        let ambient = |flow: &CarrierPoint, velocity: Vector| {
            let slip = sub(flow.velocity, velocity);
            let slip_squared = if self.settings.slip {
                dot(slip, slip)
            } else {
                0.0
            };
            Ambient {
                pressure: flow.pressure,
                slip_squared,
                ..Ambient::default()
            }
        };
        Linear {
            start_time,
            end_time,
            start: ambient(&self.flow[0], velocity),
            end: ambient(&self.flow[1], end),
        }
    }

    /// Flow that the bubble feels at a place and time.
    fn sample(&mut self, position: Vector, time: f64) -> Result<CarrierPoint, Stop> {
        let radius = self.bubble.state.radius;
        let point = if self.settings.averaging.over_surface(radius) {
            let mean = surface_average(self.carrier, position, radius, time)?;
            self.counts.average_points_left_out += u64::from(mean.left_out);
            mean.point
        } else {
            self.carrier.at(position, time)?
        };
        if point.is_sound() {
            Ok(point)
        } else {
            Err(Stop::Flow(CarrierError::NotFinite { position }))
        }
    }

    /// Largest substep, s.
    fn length(&self, here: &CarrierPoint) -> f64 {
        let (settings, bubble) = (self.settings, &self.bubble);
        let speed = norm(bubble.velocity).max(norm(here.velocity));
        let way = settings.courant * self.carrier.length_scale(bubble.position) / speed;
        let mut length = way.min(settings.time_share * self.carrier.time_scale());
        if settings.slip && settings.dynamics.is_some() {
            let state = &bubble.state;
            let inside = state.bubble_pressure(&settings.liquid, &bubble.gas);
            let push = (inside - here.pressure).abs() / settings.liquid.density;
            let swing = state.radius / push.sqrt();
            let stretch = state.radius / state.wall_velocity.abs();
            length = length.min(settings.radius_share * swing.min(stretch));
        }
        length
    }

    /// Velocity and place follow to a time (s) at which the radius is known.
    fn travel(&mut self, time: f64, radius: f64) {
        let (start, before) = self.reached;
        let duration = time - start;
        if duration <= 0.0 {
            self.reached = (self.reached.0, radius);
            return;
        }
        let whole = self.ends[1] - self.ends[0];
        let x = |t: f64| (t - self.ends[0]) / whole;
        let flow = [
            between(&self.flow[0], &self.flow[1], x(start)),
            between(&self.flow[0], &self.flow[1], x(time)),
        ];
        let leg = Leg {
            flow,
            radius: [before, radius],
            duration,
        };
        let old = self.bubble.velocity;
        let after = kick(&self.settings.forces, self.bubble.mass, old, &leg);
        let mut place = along(
            self.bubble.position,
            duration,
            mix(old, after.velocity, 0.5),
        );
        let mut velocity = after.velocity;
        if self.hold(&mut place, Some(&mut velocity)) {
            self.counts.wall_contacts += 1;
        }
        self.bubble.velocity = velocity;
        self.bubble.position = place;
        self.bubble.slip_ledger.add(&after.energy);
        self.reached = (time, radius);
    }

    /// Keeps the centre at least the reference radius of its gas away from the wall, and stops its motion towards it.
    fn hold(&self, place: &mut Vector, velocity: Option<&mut Vector>) -> bool {
        let Some(wall) = self.carrier.wall(*place) else {
            return false;
        };
        let missing = self.bubble.gas.radius - wall.distance;
        if missing <= 0.0 {
            return false;
        }
        *place = along(*place, missing, wall.normal);
        if let Some(velocity) = velocity {
            let inwards = dot(*velocity, wall.normal).min(0.0);
            *velocity = along(*velocity, -inwards, wall.normal);
        }
        true
    }

    fn collapse_begins(&mut self, event: &Event) {
        let position = self.bubble.position;
        let wall = self.carrier.wall(position);
        self.bubble.begin = Some(Begin {
            time: event.time,
            max_radius: event.radius,
            position,
            wall_distance: wall.map(|w| w.distance),
            wall_point: wall.map(|w| sub(position, scale(w.distance, w.normal))),
        });
    }

    fn collapse_ends(&mut self, event: &Event) {
        let Some(begin) = self.bubble.begin.take() else {
            // The bubble came into the cloud while it collapsed.
            self.counts.collapses += 1;
            self.counts.not_assessed += 1;
            return;
        };
        let assess = |wall_distance| {
            self.settings.erosion.assess(&NearWallCollapse {
                max_radius: begin.max_radius,
                min_radius: event.radius,
                pressure: event.bubble_pressure,
                wall_distance,
            })
        };
        let assessment: Option<Assessment> = begin.wall_distance.map(assess);
        self.counts.count(assessment.as_ref());
        self.records.push(CollapseRecord {
            bubble: self.bubble.id,
            begin,
            time: event.time,
            position: self.bubble.position,
            min_radius: event.radius,
            peak_pressure: event.bubble_pressure,
            assessment,
        });
    }
}

impl<C: Carrier> Watch for Traveller<'_, C> {
    const STEPS: bool = true;

    fn step(&mut self, step: &DenseStep) {
        let before = self.reached.1;
        let after = step.at_fraction(1.0)[0];
        let parts = ((after / before).ln().abs() / RADIUS_PART).ceil().max(1.0);
        let count = if parts.is_finite() { parts as u32 } else { 1 };
        let length = step.end_time() - step.start_time();
        for k in 1..=count {
            let x = f64::from(k) / f64::from(count);
            let radius = step.at_fraction(x)[0];
            self.travel(step.start_time() + x * length, radius);
        }
    }

    fn event(&mut self, event: &Event) {
        match event.kind {
            EventKind::CollapseBegins => self.collapse_begins(event),
            EventKind::SmallestRadius => self.collapse_ends(event),
            EventKind::Closed => {}
        }
    }
}
