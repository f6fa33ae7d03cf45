use spade::{DelaunayTriangulation, Point2, Triangulation};
mod lines;

fn main() {
    lines::serve(|points| {
        let mut made = DelaunayTriangulation::<Point2<f64>>::new();
        for p in points {
            made.insert(Point2::new(p[0], p[1])).expect("insert returns an error");
        }
        made.inner_faces().map(|face| face.vertices().iter().map(|v| v.fix().index()).collect()).collect()
    });
}
