//! What every adapter in Rust does: reads points from the standard input, writes triangles to the standard output.
use std::io::{stdin, stdout, BufRead, Write};
use std::panic::{catch_unwind, AssertUnwindSafe};

pub fn serve(triangulate: impl Fn(&[Vec<f64>]) -> Vec<Vec<usize>>) {
    std::panic::set_hook(Box::new(|_| ()));
    let mut lines = stdin().lock().lines().map(|line| line.unwrap());
    while let Some(header) = lines.next() {
        let count: usize = header.split(' ').next().unwrap().parse().unwrap();
        let points: Vec<Vec<f64>> = (0..count)
            .map(|_| lines.next().unwrap().split(' ').map(|x| x.parse().unwrap()).collect())
            .collect();
        let text = match catch_unwind(AssertUnwindSafe(|| triangulate(&points))) {
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
