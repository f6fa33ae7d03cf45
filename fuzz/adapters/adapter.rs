// A worker for `circumspect campaign --worker -- ./mine`: rustc -O mine.rs, or src/main.rs of a crate.
use std::io::{stdin, BufRead};

// Put your own library here: a slice of points, and back come rows of indices, from 0.
fn triangulate(points: &[Vec<f64>]) -> Result<Vec<Vec<usize>>, String> {
    Err(format!("no library yet for {} points", points.len()))
}

fn main() {
    let mut lines = stdin().lock().lines().map(|line| line.unwrap());
    while let Some(header) = lines.next() {
        let count = header.split(' ').next().unwrap().parse().unwrap();
        let point = |line: String| line.split(' ').map(|x| x.parse().unwrap()).collect();
        let points: Vec<Vec<f64>> = lines.by_ref().take(count).map(point).collect();
        match triangulate(&points) {
            Err(text) => println!("error {text}"), // where its documents let it refuse
            Ok(simplices) => {
                let row = |s: &Vec<usize>| s.iter().map(|v| format!("{v} ")).collect::<String>() + "\n";
                print!("{}\n{}", simplices.len(), simplices.iter().map(row).collect::<String>());
            }
        }
    }
}
