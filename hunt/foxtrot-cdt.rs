mod lines;

fn main() {
    lines::serve(|points| {
        let own: Vec<(f64, f64)> = points.iter().map(|p| (p[0], p[1])).collect();
        let made = cdt::triangulate_points(&own).expect("triangulate_points returns an error");
        made.iter().map(|t| vec![t.0, t.1, t.2]).collect()
    });
}
