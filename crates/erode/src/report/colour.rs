//! Colour maps and colour bars.

use super::svg::{Anchor, LABEL_SIZE, Svg, TICK_SIZE};
use super::units::{Scale, ticks};

/// Colour of a void and of places without particles.
pub(crate) const VOID: [u8; 3] = [255, 255, 255];

/// A colour map: a number from 0 to 1 becomes a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// Perceptually uniform, dark blue to yellow (viridis: S. van der Walt, N. Smith, 2015, CC0; every 16th entry).
    Viridis,
    /// Perceptually uniform, pale yellow to nearly black (inferno of the same authors, CC0, reversed).
    Heat,
    /// Diverging, blue over grey to red (K. Moreland, "Diverging color maps for scientific visualization", 2009).
    CoolWarm,
}

const VIRIDIS: [u32; 17] = [
    0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c,
    0x1f9f88, 0x27ad81, 0x3dbc74, 0x5cc863, 0x81d34d, 0xaadc32, 0xd5e21a, 0xfde725,
];
const HEAT: [u32; 17] = [
    0xfcffa4, 0xf2e865, 0xf9c932, 0xfcaa0f, 0xf98c0a, 0xf1711f, 0xe35933, 0xd04545, 0xbc3754,
    0xa32c61, 0x8a226a, 0x71196e, 0x57106e, 0x3d0965, 0x210c4a, 0x0b0724, 0x000004,
];
const COOL_WARM: [u32; 17] = [
    0x3b4cc0, 0x4d68d7, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2ff, 0xb8d0f9, 0xccd9ee, 0xdddddd,
    0xecd3c5, 0xf5c4ad, 0xf7b194, 0xf49a7b, 0xec7f63, 0xde604d, 0xcb3e38, 0xb40426,
];

impl ColourMap {
    /// Colour (red, green, blue) of `part` in 0..1; values outside take the colour of the nearer end.
    pub fn colour(self, part: f64) -> [u8; 3] {
        let table = match self {
            Self::Viridis => &VIRIDIS,
            Self::Heat => &HEAT,
            Self::CoolWarm => &COOL_WARM,
        };
        let last = table.len() - 1;
        let place = part.clamp(0.0, 1.0) * last as f64;
        let index = (place.floor() as usize).min(last - 1);
        let share = place - index as f64;
        let channel = |shift: u32| {
            let [a, b] = [table[index], table[index + 1]].map(|c| f64::from((c >> shift) & 0xff));
            (a + share * (b - a)).round() as u8
        };
        [channel(16), channel(8), channel(0)]
    }
}

/// How values of a field become colours.
#[derive(Debug, Clone)]
pub struct Colouring {
    /// The quantity in words; without it no colour bar is drawn in a picture.
    pub label: String,
    /// Its SI unit.
    pub unit: String,
    /// Values (SI) at the two ends of the map; beyond them the end colour is used and the bar shows an arrow.
    pub range: [f64; 2],
    /// The map.
    pub map: ColourMap,
    /// Values at or below this number take this colour instead (material that is still elastic, say).
    pub floor: Option<(f64, [u8; 3])>,
}

impl Colouring {
    /// Colour of a value; grey for NaN.
    pub(crate) fn colour(&self, value: f64) -> [u8; 3] {
        if value.is_nan() {
            return [160, 160, 160];
        }
        match &self.floor {
            Some((floor, colour)) if value <= *floor => *colour,
            _ => self
                .map
                .colour((value - self.range[0]) / (self.range[1] - self.range[0])),
        }
    }
}

/// Place and size of a colour bar in a drawing, and which ends get an arrow.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bar {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) height: f64,
    /// Values lie below and above the range.
    pub(crate) beyond: [bool; 2],
}

const BAR_WIDTH: f64 = 15.0;
const ARROW: f64 = 9.0;

/// Draws a colour bar with ticks and label.
pub(crate) fn draw_bar(svg: &mut Svg, bar: Bar, colouring: &Colouring) {
    let Bar {
        left,
        top,
        height,
        beyond,
    } = bar;
    let right = left + BAR_WIDTH;
    let strips = 64;
    for strip in 0..strips {
        let low = f64::from(strip) / f64::from(strips);
        let y = top + height * (1.0 - low);
        // A little overlap hides seams between the strips.
        let upper = (y - height / f64::from(strips) - 0.6).max(top);
        let colour = css(colouring.map.colour(low + 0.5 / f64::from(strips)));
        svg.polygon(
            &[[left, y], [right, y], [right, upper], [left, upper]],
            &colour,
        );
    }
    svg.frame(left, top, BAR_WIDTH, height);
    let middle = left + 0.5 * BAR_WIDTH;
    if beyond[1] {
        let corners = [[left, top], [right, top], [middle, top - ARROW]];
        svg.polygon(&corners, &css(colouring.map.colour(1.0)));
    }
    if beyond[0] {
        let y = top + height;
        svg.polygon(
            &[[left, y], [right, y], [middle, y + ARROW]],
            &css(colouring.map.colour(0.0)),
        );
    }
    let [low, high] = colouring.range;
    let scale = Scale::for_magnitude(low.abs().max(high.abs()), &colouring.unit);
    for (value, label) in ticks(
        low / scale.factor,
        high / scale.factor,
        (height / 32.0) as usize,
    ) {
        let part = (value * scale.factor - low) / (high - low);
        let y = top + height * (1.0 - part);
        svg.line([right, y], [right + 4.0, y], super::svg::INK, 1.0);
        svg.text([right + 7.0, y + 4.0], Anchor::Start, TICK_SIZE, &label);
    }
    let text = format!("{}{}", colouring.label, scale.bracketed());
    svg.upright_text(
        [right + 62.0, top + 0.5 * height],
        Anchor::Middle,
        LABEL_SIZE,
        &text,
    );
}

/// A colour as in CSS.
pub(crate) fn css([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A range for colours that a few extreme values do not spoil: the `tail` smallest and largest shares of the finite
/// values are left out.
pub(crate) fn robust_range(values: &[f64], tail: f64) -> Option<[f64; 2]> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    if sorted.is_empty() {
        return None;
    }
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64).round() as usize];
    Some([at(tail), at(1.0 - tail)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Luma of Rec. 709, good enough to tell dark from bright.
    fn brightness(c: [u8; 3]) -> f64 {
        0.2126 * f64::from(c[0]) + 0.7152 * f64::from(c[1]) + 0.0722 * f64::from(c[2])
    }

    #[test]
    fn sequential_maps_change_brightness_in_one_direction() {
        let steps: Vec<f64> = (0..=64).map(|k| f64::from(k) / 64.0).collect();
        for pair in steps.windows(2) {
            let of = |map: ColourMap, k: usize| brightness(map.colour(pair[k]));
            assert!(
                of(ColourMap::Viridis, 1) > of(ColourMap::Viridis, 0) - 0.5,
                "{pair:?}"
            );
            assert!(
                of(ColourMap::Heat, 1) < of(ColourMap::Heat, 0) + 0.5,
                "{pair:?}"
            );
        }
        let [red, green, blue] = ColourMap::CoolWarm.colour(0.5);
        assert!(red == green && green == blue);
    }

    #[test]
    fn out_of_range_values_take_the_end_colours() {
        assert_eq!(ColourMap::Viridis.colour(-3.0), [0x44, 0x01, 0x54]);
        assert_eq!(ColourMap::Viridis.colour(7.0), [0xfd, 0xe7, 0x25]);
        let values: Vec<f64> = (0..1000).map(f64::from).chain([1e9, f64::NAN]).collect();
        let [low, high] = robust_range(&values, 0.01).unwrap();
        assert!(low == 10.0 && high == 990.0, "{low} {high}");
    }
}
