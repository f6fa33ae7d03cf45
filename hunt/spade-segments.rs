use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
mod lines;

fn main() {
    lines::serve_domains(|points, segments| {
        let own: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
        let edges: Vec<[usize; 2]> = segments.iter().map(|s| [s[0] as usize, s[1] as usize]).collect();
        let made = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt_stable(own, edges)
            .expect("bulk_load_cdt_stable returns an error");
        made.inner_faces().map(|face| face.vertices().iter().map(|v| v.fix().index()).collect()).collect()
    });
}
