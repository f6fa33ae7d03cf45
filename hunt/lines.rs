//! What every adapter in Rust does: it answers the cases of `circumspect campaign --worker` (docs/workers.md).
use std::io::{stdin, stdout, BufRead, Write};

/// `triangulate` is given points, and returns rows of indices. A panic ends the process, with exit code 101.
#[allow(dead_code)]
pub fn serve(triangulate: impl Fn(&[Vec<f64>]) -> Vec<Vec<usize>>) {
    answer_all(|points, _| triangulate(points), false);
}

/// The same of the plane with segments that have to be edges: a worker answers domains with an .off file.
#[allow(dead_code)]
pub fn serve_domains(triangulate: impl Fn(&[Vec<f64>], &[Vec<f64>]) -> Vec<Vec<usize>>) {
    answer_all(triangulate, true);
}

fn answer_all(triangulate: impl Fn(&[Vec<f64>], &[Vec<f64>]) -> Vec<Vec<usize>>, of_domains: bool) {
    let mut lines = stdin().lock().lines().map(|line| line.unwrap());
    while let Some(header) = lines.next() {
        let sizes: Vec<usize> = header.split(' ').map(|x| x.parse().unwrap()).collect();
        let rows: Vec<String> = (0..sizes[0] + sizes[3]).map(|_| lines.next().unwrap()).collect();
        for _ in 0..sizes[5] {
            lines.next(); // a point in a hole: the hull is filled
        }
        let given: Vec<Vec<f64>> =
            rows.iter().map(|row| row.split(' ').map(|x| x.parse().unwrap()).collect()).collect();
        let (points, segments) = given.split_at(sizes[0]);
        let made = triangulate(points, segments);
        let mut text = if of_domains {
            format!("nOFF 2\n{} {} 0\n{}\n", sizes[0], made.len(), rows[..sizes[0]].join("\n"))
        } else {
            format!("{}\n", made.len())
        };
        for simplex in made {
            let own: Vec<String> = simplex.iter().map(|v| v.to_string()).collect();
            text += &format!("{}{}\n", if of_domains { "3 " } else { "" }, own.join(" "));
        }
        stdout().write_all(text.as_bytes()).unwrap();
        stdout().flush().unwrap();
    }
}
