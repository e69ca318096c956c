//! Pictures for the report, as SVG.

use std::fmt::Write;

use crate::tally::{BINS, Bin};

const SIDE: f64 = 260.0;
const MARGIN: f64 = 44.0;

struct Frame {
    svg: String,
    left: f64,
    x: [f64; 2],
    y: [f64; 2],
}

impl Frame {
    fn new(panel: usize, x: [f64; 2], y: [f64; 2], title: &str, labels: [&str; 2], ticks: [&[f64]; 2]) -> Self {
        let left = MARGIN + panel as f64 * (SIDE + 1.6 * MARGIN);
        let mut f = Self { svg: String::new(), left, x, y };
        let _ = write!(
            f.svg,
            "<rect x='{left}' y='{MARGIN}' width='{SIDE}' height='{SIDE}' fill='none' stroke='#888'/>\
            <text x='{}' y='{}' text-anchor='middle' font-weight='bold'>{title}</text>\
            <text x='{}' y='{}' text-anchor='middle'>{}</text>\
            <text transform='translate({},{}) rotate(-90)' text-anchor='middle'>{}</text>",
            left + SIDE / 2.0,
            MARGIN - 14.0,
            left + SIDE / 2.0,
            MARGIN + SIDE + 34.0,
            labels[0],
            left - 30.0,
            MARGIN + SIDE / 2.0,
            labels[1],
        );
        for &t in ticks[0] {
            let (x, y) = (f.at_x(t), MARGIN + SIDE);
            let _ = write!(f.svg, "<text x='{x:.1}' y='{:.1}' text-anchor='middle'>{t}</text>", y + 14.0);
        }
        for &t in ticks[1] {
            let y = f.at_y(t);
            let _ = write!(f.svg, "<text x='{:.1}' y='{:.1}' text-anchor='end'>{t}</text>", left - 4.0, y + 4.0);
        }
        f
    }

    fn at_x(&self, v: f64) -> f64 {
        self.left + SIDE * (v - self.x[0]) / (self.x[1] - self.x[0])
    }

    fn at_y(&self, v: f64) -> f64 {
        MARGIN + SIDE * (1.0 - (v - self.y[0]) / (self.y[1] - self.y[0]))
    }

    fn line(&mut self, points: &[(f64, f64)], colour: &str, dashed: bool) {
        let path: Vec<String> =
            points.iter().map(|(x, y)| format!("{:.1},{:.1}", self.at_x(*x), self.at_y(*y))).collect();
        let dash = if dashed { " stroke-dasharray='4 3'" } else { "" };
        let _ = write!(
            self.svg,
            "<polyline points='{}' fill='none' stroke='{colour}' stroke-width='1.5'{dash}/>",
            path.join(" ")
        );
    }

    fn dot(&mut self, x: f64, y: f64, radius: f64, colour: &str) {
        let (x, y) = (self.at_x(x), self.at_y(y));
        let _ =
            write!(self.svg, "<circle cx='{x:.1}' cy='{y:.1}' r='{radius:.1}' fill='{colour}' fill-opacity='0.75'/>");
    }
}

fn document(panels: &[Frame]) -> String {
    let width = MARGIN + panels.len() as f64 * (SIDE + 1.6 * MARGIN);
    let body: String = panels.iter().map(|f| f.svg.as_str()).collect();
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{}' font-family='sans-serif' font-size='11' \
        fill='#333'><rect width='100%' height='100%' fill='white'/>{body}</svg>\n",
        SIDE + 2.2 * MARGIN
    )
}

/// Reliability diagrams: stated belief against how often it was true. Dots grow with the samples in them.
pub fn reliability(models: &[(&str, [Bin; BINS])]) -> String {
    let panels: Vec<Frame> = models
        .iter()
        .enumerate()
        .map(|(i, (name, bins))| {
            let ticks = [0.0, 0.25, 0.5, 0.75, 1.0];
            let labels = ["stated belief", "was within the tolerance"];
            let mut f = Frame::new(i, [0.0, 1.0], [0.0, 1.0], name, labels, [&ticks, &ticks]);
            f.line(&[(0.0, 0.0), (1.0, 1.0)], "#999", true);
            let all: f64 = bins.iter().map(|b| b.count).sum();
            let used: Vec<&Bin> = bins.iter().filter(|b| b.count > 0.0).collect();
            let points: Vec<(f64, f64)> = used.iter().map(|b| (b.stated / b.count, b.kept / b.count)).collect();
            f.line(&points, "#c44", false);
            for (b, (x, y)) in used.iter().zip(&points) {
                f.dot(*x, *y, 3.0 + 9.0 * (b.count / all).sqrt(), "#c44");
            }
            f
        })
        .collect();
    document(&panels)
}

/// Errors in stated σ, as cumulative shares, against the normal distribution.
pub fn errors(kinds: &[(&str, &[f64])]) -> String {
    let panels: Vec<Frame> = kinds
        .iter()
        .enumerate()
        .map(|(i, (name, z))| {
            let labels = ["error, in stated σ", "share with less"];
            let y_ticks = [0.0, 0.25, 0.5, 0.75, 0.95];
            let mut f = Frame::new(i, [0.0, 4.0], [0.0, 1.0], name, labels, [&[0.0, 1.0, 1.96, 3.0, 4.0], &y_ticks]);
            let normal = |z: f64| 2.0 * asbuilt_core::num::normal::cdf(z) - 1.0;
            let grid: Vec<(f64, f64)> = (0..=80).map(|k| f64::from(k) * 0.05).map(|z| (z, normal(z))).collect();
            f.line(&grid, "#999", true);
            let n = z.len().max(1) as f64;
            let steps = z.iter().enumerate().filter(|(_, z)| z.abs() <= 4.0);
            let measured: Vec<(f64, f64)> = steps.map(|(k, z)| (z.abs(), (k + 1) as f64 / n)).collect();
            f.line(&measured, "#36a", false);
            f
        })
        .collect();
    document(&panels)
}
