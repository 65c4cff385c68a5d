//! A page of text, tables and figures in one file that needs nothing from outside.

use std::fmt::Write as _;

use super::svg::escape;

const STYLE: &str = "\
:root{color:#1d2129;background:#fff;font:15px/1.5 system-ui,'Segoe UI','DejaVu Sans',Arial,sans-serif}\
body{max-width:1180px;margin:0 auto;padding:28px 24px 60px}\
h1{font-size:27px;line-height:1.25;margin:0 0 4px}\
h2{font-size:19px;margin:40px 0 10px;padding-bottom:5px;border-bottom:2px solid #d5dae1}\
p{margin:8px 0;max-width:900px}\
.sub{color:#5b6470;margin:0 0 14px}\
.absent{color:#5b6470;font-style:italic}\
.alert{background:#fdecea;border-left:4px solid #c0392b;padding:9px 14px;max-width:none}\
table{border-collapse:collapse;margin:10px 0;font-variant-numeric:tabular-nums}\
th,td{padding:5px 16px 5px 0;text-align:left;border-bottom:1px solid #e4e6ea;vertical-align:top}\
th{font-weight:600;color:#414a55;border-bottom:2px solid #d5dae1}\
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(540px,1fr));gap:18px 22px;align-items:start}\
.multiples{grid-template-columns:repeat(auto-fit,minmax(350px,1fr))}\
figure{margin:6px 0}\
figure svg{max-width:100%;height:auto;display:block}\
figcaption{color:#414a55;font-size:13.5px;margin:4px 0 0;max-width:640px}\
.columns{display:grid;grid-template-columns:repeat(auto-fit,minmax(400px,1fr));gap:0 40px;align-items:start}\
details{margin:8px 0}summary{cursor:pointer;color:#0b5394}\
pre{background:#f5f6f8;border:1px solid #e4e6ea;border-radius:4px;padding:10px 14px;overflow:auto;\
font:12.5px/1.45 ui-monospace,'DejaVu Sans Mono',Consolas,monospace;max-height:520px}\
@media print{body{max-width:none}h2,figure{break-inside:avoid}}";

/// A page being written.
#[derive(Debug, Default)]
pub(crate) struct Page {
    body: String,
}

impl Page {
    /// The title and a line below it.
    pub(crate) fn title(&mut self, title: &str, below: &str) {
        let _ = write!(
            self.body,
            "<h1>{}</h1>\n<p class=\"sub\">{}</p>\n",
            escape(title),
            escape(below)
        );
    }

    /// Starts a section.
    pub(crate) fn section(&mut self, heading: &str) {
        let _ = writeln!(self.body, "<h2>{}</h2>", escape(heading));
    }

    /// A paragraph.
    pub(crate) fn paragraph(&mut self, text: &str) {
        let _ = writeln!(self.body, "<p>{}</p>", escape(text));
    }

    /// One line that says what is not there and why.
    pub(crate) fn absent(&mut self, text: &str) {
        let _ = writeln!(self.body, "<p class=\"absent\">{}</p>", escape(text));
    }

    /// A paragraph that must not be overlooked.
    pub(crate) fn alert(&mut self, text: &str) {
        let _ = writeln!(self.body, "<p class=\"alert\">{}</p>", escape(text));
    }

    /// A table; without `heads` it has no head row.
    pub(crate) fn table(&mut self, heads: &[&str], rows: &[Vec<String>]) {
        self.body.push_str("<table>");
        if !heads.is_empty() {
            self.row("th", heads);
        }
        for row in rows {
            self.row("td", row);
        }
        self.body.push_str("</table>\n");
    }

    fn row(&mut self, cell: &str, texts: &[impl AsRef<str>]) {
        self.body.push_str("<tr>");
        for text in texts {
            let _ = write!(self.body, "<{cell}>{}</{cell}>", escape(text.as_ref()));
        }
        self.body.push_str("</tr>\n");
    }

    /// A group of figures side by side, as many as fit; each is SVG text and a caption.
    pub(crate) fn figures(&mut self, figures: &[(String, String)]) {
        self.group("figures", figures);
    }

    /// A group of small figures, three beside each other.
    pub(crate) fn multiples(&mut self, figures: &[(String, String)]) {
        self.group("figures multiples", figures);
    }

    fn group(&mut self, class: &str, figures: &[(String, String)]) {
        let _ = writeln!(self.body, "<div class=\"{class}\">");
        for (svg, caption) in figures {
            let _ = writeln!(
                self.body,
                "<figure>{svg}<figcaption>{}</figcaption></figure>",
                escape(caption)
            );
        }
        self.body.push_str("</div>\n");
    }

    /// Text that is shown on demand.
    pub(crate) fn details(&mut self, summary: &str, text: &str) {
        let _ = writeln!(
            self.body,
            "<details><summary>{}</summary><pre>{}</pre></details>",
            escape(summary),
            escape(text)
        );
    }

    /// Writes what `left` and `right` write next to each other.
    pub(crate) fn columns(&mut self, left: impl FnOnce(&mut Page), right: impl FnOnce(&mut Page)) {
        self.body.push_str("<div class=\"columns\"><div>\n");
        left(self);
        self.body.push_str("</div><div>\n");
        right(self);
        self.body.push_str("</div></div>\n");
    }

    /// The finished page.
    pub(crate) fn finish(self, title: &str) -> String {
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{}</title>\n<style>{STYLE}</style></head>\n<body>\n{}</body></html>\n",
            escape(title),
            self.body
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_break_the_page() {
        let mut page = Page::default();
        page.title("<script>", "a & b");
        page.table(&["k"], &[vec!["</table>".into()]]);
        page.details("case.toml", "x = \"<b>\"");
        let html = page.finish("t");
        assert!(
            !html.contains("<script>") && !html.contains("</table></td>") && !html.contains("<b>")
        );
        assert_eq!(
            html.matches("<table>").count(),
            html.matches("</table>").count()
        );
    }
}
