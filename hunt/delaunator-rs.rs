use delaunator::{triangulate, Point};
mod lines;

fn main() {
    lines::serve(|points| {
        let own: Vec<Point> = points.iter().map(|p| Point { x: p[0], y: p[1] }).collect();
        triangulate(&own).triangles.chunks(3).map(|t| t.to_vec()).collect()
    });
}
