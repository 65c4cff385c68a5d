//! A bubble with gas in compressible liquid, in one dimension: the equations of Euler between spheres.
//!
//! d(rho)/dt + d(r^2 rho u)/(r^2 dr) = 0, d(rho u)/dt + d(r^2 rho u^2)/(r^2 dr) + dp/dr = 0, p = p(rho) by the Tait equation of
//! the particles.
//!
//! Finite volumes between spheres that all move with the wall of the bubble, so that the shells at the wall stay as thin as they
//! were. Slopes by van Leer, values half a step ahead by Hancock, fluxes between shells by Harten, Lax and van Leer: second
//! order where the flow is smooth. At the wall the simple wave that takes the liquid to the pressure of the gas. Areas are those of
//! the volumes swept in a step: liquid at rest under the pressure of its gas stays so.
//!
//! Lengths in radii of the bubble at the start, volumes and areas for one steradian; pressure, density and speed in SI; time in
//! radii per (m/s).

use erode_physics::eos::Tait;

/// Step as a fraction of what sound needs for the thinnest shell.
const COURANT: f64 = 0.8;
/// Each shell is thicker than the one before by this part.
const GROWTH: f64 = 0.01;

/// A bubble and the liquid around it.
pub(super) struct Spherical {
    eos: Tait,
    /// Of the gas at the start, Pa, and its polytropic exponent.
    gas: (f64, f64),
    /// Density far away, kg/m3.
    far: f64,
    /// Distances of the spheres from the wall.
    sphere: Vec<f64>,
    /// Mass and momentum of each shell.
    mass: Vec<f64>,
    momentum: Vec<f64>,
    /// Speed of the wall, m/s.
    speed: f64,
    /// Radius of the bubble.
    pub(super) radius: f64,
    pub(super) time: f64,
}

/// Density (kg/m3) and speed (m/s).
type State = [f64; 2];

impl Spherical {
    /// Liquid at rest under `pressure` out to `extent`, its first shell `finest` thick. Once the surface is let go it has the
    /// speed of the simple wave between the two pressures.
    pub(super) fn new(
        eos: Tait,
        pressure: f64,
        gas: (f64, f64),
        (finest, extent): (f64, f64),
    ) -> Self {
        let far = eos.density(pressure);
        let (mut sphere, mut thickness, mut last) = (vec![0.0], finest, 0.0);
        while last < extent {
            last += thickness;
            sphere.push(last);
            thickness *= 1.0 + GROWTH;
        }
        let shells = sphere.len() - 1;
        let mut new = Self {
            eos,
            gas,
            far,
            sphere,
            mass: Vec::new(),
            momentum: vec![0.0; shells],
            speed: eos.riemann_integral(eos.density(gas.0)) - eos.riemann_integral(far),
            radius: 1.0,
            time: 0.0,
        };
        new.mass = (0..shells).map(|i| far * new.volume(i)).collect();
        new
    }

    fn volume(&self, i: usize) -> f64 {
        let cube = |k: usize| (self.radius + self.sphere[k]).powi(3);
        (cube(i + 1) - cube(i)) / 3.0
    }

    /// Middle of a shell, from the wall.
    fn middle(&self, i: usize) -> f64 {
        0.5 * (self.sphere[i] + self.sphere[i + 1])
    }

    /// Kinetic energy and compression of the liquid and energy of the gas, for one steradian.
    #[cfg(test)]
    fn energy(&self) -> f64 {
        let shell = |i: usize| {
            let (m, q) = (self.mass[i], self.momentum[i]);
            0.5 * q * q / m + m * self.eos.specific_energy(m / self.volume(i))
        };
        let gas = self.gas_pressure(self.radius) * self.radius.powi(3) / 3.0 / (self.gas.1 - 1.0);
        gas + (0..self.mass.len()).map(shell).sum::<f64>()
    }

    fn gas_pressure(&self, radius: f64) -> f64 {
        self.gas.0 * radius.powf(-3.0 * self.gas.1)
    }

    /// One step.
    pub(super) fn step(&mut self) {
        let states: Vec<State> = (0..self.mass.len())
            .map(|i| {
                [
                    self.mass[i] / self.volume(i),
                    self.momentum[i] / self.mass[i],
                ]
            })
            .collect();
        let rate = |(i, s): (usize, &State)| {
            let fastest = self.eos.sound_speed_at(s[0]) + (s[1] - self.speed).abs();
            fastest / (self.sphere[i + 1] - self.sphere[i])
        };
        let dt = COURANT / states.iter().enumerate().map(rate).fold(0.0, f64::max);
        let ahead: Vec<[State; 2]> = (0..states.len())
            .map(|i| self.ahead(&states, i, 0.5 * dt))
            .collect();
        let inside = self.gas_pressure(self.radius + 0.5 * dt * self.speed);
        let [density, speed] = ahead[0][0];
        let integral = |rho: f64| self.eos.riemann_integral(rho);
        self.speed = speed + integral(self.eos.density(inside)) - integral(density);
        let new = self.radius + dt * self.speed;
        let area = |k: usize| {
            let [a, b] = [self.radius, new].map(|r| r + self.sphere[k]);
            (a * a + a * b + b * b) / 3.0
        };
        let mut left = [0.0, inside * area(0)];
        for i in 0..ahead.len() {
            let beyond = ahead.get(i + 1).map_or([self.far, 0.0], |s| s[0]);
            let right = self.flux(ahead[i][1], beyond).map(|f| f * area(i + 1));
            let pressure = self.eos.pressure(0.5 * (ahead[i][0][0] + ahead[i][1][0]));
            let side = pressure * (area(i + 1) - area(i));
            self.mass[i] += dt * (left[0] - right[0]);
            self.momentum[i] += dt * (left[1] - right[1] + side);
            left = right;
        }
        self.radius = new;
        self.time += dt;
    }

    /// States at both sides of a shell, `half` a step ahead.
    fn ahead(&self, states: &[State], i: usize, half: f64) -> [State; 2] {
        let slope = |k: usize, a: usize| {
            (states[a + 1][k] - states[a][k]) / (self.middle(a + 1) - self.middle(a))
        };
        let slopes = [0, 1].map(|k| match i {
            _ if i + 1 == states.len() => 0.0,
            0 => slope(k, 0),
            _ => van_leer(slope(k, i - 1), slope(k, i)),
        });
        let ([rho, u], [drho, du]) = (states[i], slopes);
        let (c, across) = (self.eos.sound_speed_at(rho), u - self.speed);
        let spread = 2.0 * u / (self.radius + self.middle(i));
        let rho = rho - half * (across * drho + rho * (du + spread));
        let u = u - half * (across * du + c * c / rho * drho);
        let to_side = 0.5 * (self.sphere[i + 1] - self.sphere[i]);
        [-to_side, to_side].map(|d| [rho + d * drho, u + d * du])
    }

    /// Mass and momentum that pass a sphere, per area and time.
    fn flux(&self, left: State, right: State) -> [f64; 2] {
        let [a, b] = [left, right].map(|s| self.eos.sound_speed_at(s[0]));
        let slowest = (left[1] - a).min(right[1] - b) - self.speed;
        let fastest = (left[1] + a).max(right[1] + b) - self.speed;
        let carried = |[rho, u]: State| {
            let v = u - self.speed;
            [rho * v, rho * u * v + self.eos.pressure(rho)]
        };
        if slowest >= 0.0 {
            return carried(left);
        }
        if fastest <= 0.0 {
            return carried(right);
        }
        let (f, g) = (carried(left), carried(right));
        let jump = [right[0] - left[0], right[0] * right[1] - left[0] * left[1]];
        [0, 1].map(|k| {
            (fastest * f[k] - slowest * g[k] + slowest * fastest * jump[k]) / (fastest - slowest)
        })
    }
}

fn van_leer(a: f64, b: f64) -> f64 {
    if a * b <= 0.0 {
        0.0
    } else {
        2.0 * a * b / (a + b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: Tait = Tait {
        reference_density: 1000.0,
        sound_speed: 1500.0,
        gamma: 7.0,
    };

    #[test]
    fn liquid_under_the_pressure_of_its_gas_stays_at_rest() {
        let mut bubble = Spherical::new(WATER, 5e6, (5e6, 1.4), (0.02, 5.0));
        for _ in 0..500 {
            bubble.step();
        }
        assert!((bubble.radius - 1.0).abs() < 1e-12 && bubble.speed.abs() < 1e-9);
    }

    /// Radius at a time, and the change of energy until then in units of p V0; nothing has reached the far side.
    fn collapse(finest: f64) -> (f64, f64) {
        let pressure = 50e6;
        let mut bubble = Spherical::new(WATER, pressure, (1e5, 1.4), (finest, 10.0));
        let (first, end) = (bubble.energy(), bubble.sphere[bubble.sphere.len() - 1]);
        while bubble.time < 3e-3 {
            bubble.step();
        }
        // The spheres move with the wall: what they leave behind at the far side is at rest.
        let left = ((end + 1.0).powi(3) - (end + bubble.radius).powi(3)) / 3.0;
        let left = left * bubble.far * WATER.specific_energy(bubble.far);
        let change = (bubble.energy() + left - first) / (pressure / 3.0);
        (bubble.radius, change)
    }

    #[test]
    fn the_radius_converges_and_the_energy_is_kept() {
        let runs = [0.04, 0.02, 0.01].map(collapse);
        println!("{runs:?}");
        // The simple wave of the start is not smooth: between the first and the second order.
        let steps = [0, 1].map(|k| (runs[k].0 - runs[k + 1].0).abs());
        assert!(steps[1] < 0.5 * steps[0] && steps[1] < 1e-3, "{runs:?}");
        // Its sound is smeared where the shells are thick, far away; what is lost of it falls with them.
        let losses = runs.map(|r| -r.1);
        assert!(losses.is_sorted_by(|a, b| a > b), "{runs:?}");
        assert!(losses[2] > 0.0 && losses[2] < 5e-3, "{runs:?}");
    }
}
