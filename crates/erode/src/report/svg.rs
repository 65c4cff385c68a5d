//! A small writer of SVG: lines, rectangles, text and embedded pictures, nothing more.

use std::fmt::Write as _;

/// Sizes of text in pixels.
pub(crate) const TICK_SIZE: f64 = 12.0;
/// Size of axis labels, legends and titles.
pub(crate) const LABEL_SIZE: f64 = 13.0;
/// Colour of axes and text.
pub(crate) const INK: &str = "#222";
/// Colour of grid lines.
pub(crate) const GRID: &str = "#e4e6ea";

/// Where a text is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// An SVG drawing being written; x to the right, y downwards, in pixels.
#[derive(Debug)]
pub(crate) struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// An empty drawing; `label` is what a screen reader says.
    pub(crate) fn new(width: f64, height: f64, label: &str) -> Self {
        let mut body = String::new();
        if !label.is_empty() {
            let _ = write!(body, "<title>{}</title>", escape(label));
        }
        Self {
            width,
            height,
            body,
        }
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], colour: &str, width: f64) {
        let _ = write!(
            self.body,
            r#"<path d="M{} {}L{} {}" stroke="{colour}" stroke-width="{width}" fill="none"/>"#,
            px(from[0]),
            px(from[1]),
            px(to[0]),
            px(to[1])
        );
    }

    /// A dashed straight line.
    pub(crate) fn dashed_line(&mut self, from: [f64; 2], to: [f64; 2], colour: &str, dashes: &str) {
        let _ = write!(
            self.body,
            r#"<path d="M{} {}L{} {}" stroke="{colour}" stroke-width="1" stroke-dasharray="{dashes}" fill="none"/>"#,
            px(from[0]),
            px(from[1]),
            px(to[0]),
            px(to[1])
        );
    }

    /// A curve through `points`, broken where a point is not finite; `dashes` is empty for a solid line.
    pub(crate) fn curve(&mut self, points: &[[f64; 2]], colour: &str, width: f64, dashes: &str) {
        let mut path = String::new();
        let mut pen_down = false;
        for point in points {
            let finite = point[0].is_finite() && point[1].is_finite();
            if finite {
                let command = if pen_down { 'L' } else { 'M' };
                let _ = write!(path, "{command}{} {}", px(point[0]), px(point[1]));
            }
            pen_down = finite;
        }
        let dash = if dashes.is_empty() {
            String::new()
        } else {
            format!(r#" stroke-dasharray="{dashes}""#)
        };
        let _ = write!(
            self.body,
            r#"<path d="{path}" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round" fill="none"{dash}/>"#
        );
    }

    /// A round marker.
    pub(crate) fn dot(&mut self, at: [f64; 2], radius: f64, colour: &str) {
        let (x, y) = (px(at[0]), px(at[1]));
        let _ = write!(
            self.body,
            r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="{colour}" fill-opacity="0.75"/>"#
        );
    }

    /// A filled polygon.
    pub(crate) fn polygon(&mut self, corners: &[[f64; 2]], colour: &str) {
        let mut list = String::new();
        for corner in corners {
            let _ = write!(list, "{},{} ", px(corner[0]), px(corner[1]));
        }
        let _ = write!(
            self.body,
            r#"<polygon points="{}" fill="{colour}"/>"#,
            list.trim_end()
        );
    }

    /// A rectangle with outline (no fill).
    pub(crate) fn frame(&mut self, x: f64, y: f64, width: f64, height: f64) {
        let _ = write!(
            self.body,
            r#"<rect x="{}" y="{}" width="{}" height="{}" fill="none" stroke="{INK}" stroke-width="1"/>"#,
            px(x),
            px(y),
            px(width),
            px(height)
        );
    }

    /// Text with its baseline at `at`.
    pub(crate) fn text(&mut self, at: [f64; 2], anchor: Anchor, size: f64, text: &str) {
        self.styled_text(at, anchor, size, "", text);
    }

    /// Bold text with its baseline at `at`.
    pub(crate) fn bold_text(&mut self, at: [f64; 2], anchor: Anchor, size: f64, text: &str) {
        self.styled_text(at, anchor, size, r#" font-weight="600""#, text);
    }

    /// Text turned by 90 degrees, reading upwards, with a white rim so that it stays readable on top of curves.
    pub(crate) fn upright_text(&mut self, at: [f64; 2], anchor: Anchor, size: f64, text: &str) {
        let turn = format!(
            r##" transform="rotate(-90 {} {})" paint-order="stroke" stroke="#fff" stroke-width="3""##,
            px(at[0]),
            px(at[1])
        );
        self.styled_text(at, anchor, size, &turn, text);
    }

    fn styled_text(
        &mut self,
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        attributes: &str,
        text: &str,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = write!(
            self.body,
            r#"<text x="{}" y="{}" text-anchor="{anchor}" font-size="{size}" fill="{INK}"{attributes}>{}</text>"#,
            px(at[0]),
            px(at[1]),
            escape(text)
        );
    }

    /// A PNG picture stretched over a rectangle.
    pub(crate) fn image(&mut self, x: f64, y: f64, width: f64, height: f64, data_uri: &str) {
        let _ = write!(
            self.body,
            r#"<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="{data_uri}"/>"#,
            px(x),
            px(y),
            px(width),
            px(height)
        );
    }

    /// Starts a part whose content is cut at a rectangle; its coordinates stay those of the drawing.
    pub(crate) fn begin_clip(&mut self, x: f64, y: f64, width: f64, height: f64) {
        let (x, y, width, height) = (px(x), px(y), px(width), px(height));
        let _ = write!(
            self.body,
            r#"<svg x="{x}" y="{y}" width="{width}" height="{height}" viewBox="{x} {y} {width} {height}">"#
        );
    }

    /// Ends the part begun with `begin_clip`.
    pub(crate) fn end_clip(&mut self) {
        self.body.push_str("</svg>");
    }

    /// The finished drawing, usable as a file and inline in a page.
    pub(crate) fn finish(self) -> String {
        let (width, height) = (px(self.width), px(self.height));
        format!(
            concat!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {} {}" role="img" "#,
                r#"font-family="system-ui, 'Segoe UI', 'DejaVu Sans', Arial, sans-serif">{}</svg>"#
            ),
            width, height, width, height, self.body
        )
    }
}

/// How wide a text of size `size` is at most, about (fonts differ from machine to machine).
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    0.6 * size * text.chars().count() as f64
}

/// Text safe between tags and in attributes.
pub(crate) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            // Control characters are not allowed in XML and would make the whole drawing unreadable.
            c if c.is_control() && c != '\n' && c != '\t' => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}

/// A coordinate with two decimals at most: small files, no visible loss.
fn px(value: f64) -> String {
    // Curves leave the plot area far away; browsers lose precision beyond about 1e6.
    let text = format!("{:.2}", value.clamp(-1e5, 1e5));
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_curves_break_at_gaps() {
        let mut svg = Svg::new(10.0, 10.0, "a < b");
        svg.curve(
            &[[0.0, 0.0], [1.0, f64::NAN], [2.0, 2.0], [3.0, 3.004]],
            "#000",
            1.0,
            "",
        );
        let text = svg.finish();
        assert!(text.contains("<title>a &lt; b</title>"));
        assert!(text.contains(r#"d="M0 0M2 2L3 3""#), "{text}");
        assert_eq!(escape("a\u{1}\"<&>"), "a\u{fffd}&quot;&lt;&amp;&gt;");
    }
}
