use spade::{DelaunayTriangulation, Point2, Triangulation};
mod lines;

fn main() {
    lines::serve(|points| {
        let own: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
        let made = DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(own).expect("bulk_load_stable returns an error");
        made.inner_faces().map(|face| face.vertices().iter().map(|v| v.fix().index()).collect()).collect()
    });
}
