//! What every adapter in Rust does: reads points from the standard input, writes triangles to the standard output.
use std::io::{stdin, stdout, BufRead, Write};
use std::panic::{catch_unwind, AssertUnwindSafe};

#[allow(dead_code)]
pub fn serve(triangulate: impl Fn(&[Vec<f64>]) -> Vec<Vec<usize>>) {
    serve_domains(|points, _| triangulate(points));
}

/// `triangulate` is given the points, and the segments that are to be edges.
pub fn serve_domains(triangulate: impl Fn(&[Vec<f64>], &[Vec<f64>]) -> Vec<Vec<usize>>) {
    std::panic::set_hook(Box::new(|_| ()));
    let mut lines = stdin().lock().lines().map(|line| line.unwrap());
    while let Some(header) = lines.next() {
        let sizes: Vec<usize> = header.split(' ').map(|x| x.parse().unwrap()).collect();
        let rows = sizes[0] + sizes.get(2).unwrap_or(&0);
        let given: Vec<Vec<f64>> = (0..rows)
            .map(|_| lines.next().unwrap().split(' ').map(|x| x.parse().unwrap()).collect())
            .collect();
        let (points, segments) = given.split_at(sizes[0]);
        let text = match catch_unwind(AssertUnwindSafe(|| triangulate(points, segments))) {
            Ok(made) => {
                let rows = made.iter().map(|s| s.iter().map(|v| v.to_string()).collect::<Vec<_>>().join(" ") + "\n");
                format!("{} {}\n", made.len(), points[0].len() + 1) + &rows.collect::<String>()
            }
            Err(cause) => {
                let said = cause.downcast_ref::<String>().map(|s| s.as_str());
                let said = said.or(cause.downcast_ref::<&str>().copied()).unwrap_or("a panic");
                format!("raised {}\n", said.lines().next().unwrap_or(""))
            }
        };
        stdout().write_all(text.as_bytes()).unwrap();
        stdout().flush().unwrap();
    }
}
