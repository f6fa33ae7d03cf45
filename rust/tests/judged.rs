//! What the crate answers, as its users ask it.
use circumspect::{assert_delaunay, assert_triangulation, check, generate, in_ball, orient, Error};

const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.9, 0.9]];

#[test]
fn a_mesh_that_holds() {
    let verdict = check("delaunay", &POINTS, &[[0, 1, 3], [0, 3, 2]]).unwrap();
    assert_eq!(verdict.text, "holds: delaunay mesh 4 points 2 triangles unique canonical\n");
    assert_eq!((verdict.holds, verdict.unique, verdict.canonical), (true, Some(true), Some(true)));
    assert!(verdict.rules.is_empty());
    assert_delaunay!(POINTS, [[0_usize, 1, 3], [0, 3, 2]]);
    assert_triangulation!(POINTS.to_vec(), vec![[0_u32, 1, 2], [1, 3, 2]]);
}

#[test]
#[should_panic(expected = "delaunay.facet-not-local")]
fn a_mesh_that_fails_panics_with_its_witness() {
    assert_delaunay!(POINTS, [[0, 1, 2], [1, 3, 2]]);
}

#[test]
fn an_index_that_names_no_point_is_the_meshs_fault() {
    for none in [4_u32, u32::MAX] {
        let verdict = check("delaunay", &POINTS, &[[0, 1, none]]).unwrap();
        assert_eq!(verdict.rules["triangulation.unknown-vertex"], 1);
    }
    let verdict = check("delaunay", &POINTS, &[[0, 1, usize::MAX]]).unwrap();
    assert_eq!(verdict.rules["triangulation.unknown-vertex"], 1);
}

#[test]
fn what_is_wrong_with_call_and_input_is_said() {
    let triangles = [[0, 1, 2]];
    assert!(matches!(check("delauney", &POINTS, &triangles), Err(Error::Call(text)) if text.contains("one of triangulation")));
    assert!(matches!(check("de\0", &POINTS, &triangles), Err(Error::Call(text)) if text.contains("zero byte")));
    let equal = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    assert!(matches!(check("delaunay", &equal, &triangles), Err(Error::Input(text)) if text.ends_with("found points 0 and 3 equal")));
    let strange = [[0.0, f64::NAN], [1.0, 0.0], [0.0, 1.0]];
    assert!(matches!(check("delaunay", &strange, &triangles), Err(Error::Input(text)) if text.contains("finite")));
    assert!(matches!(check::<2, 3, i32>("delaunay", &[], &[]), Err(Error::Input(text)) if text.ends_with("made nothing")));
    assert!(matches!(orient(&POINTS), Err(Error::Call(text)) if text == "expected 3 points, found 4"));
}

#[test]
fn predicates_are_exact() {
    assert_eq!(orient(&[[0.1, 0.1], [0.2, 0.2], [0.3, 0.3]]), Ok(0));
    assert_eq!(orient(&[[0.0, 0.0], [1.0, 0.0], [0.0, 5e-324]]), Ok(1));
    assert_eq!(in_ball(&POINTS), Ok(1));
}

#[test]
fn points_are_those_of_the_seed() {
    let drawn: Vec<[f64; 3]> = generate("uniform", 10, 1).unwrap();
    assert_eq!(drawn.len(), 10);
    assert_eq!(drawn, generate::<3>("uniform", 10, 1).unwrap());
    assert_ne!(drawn, generate::<3>("uniform", 10, 2).unwrap());
    assert!(matches!(generate::<2>("no-such-family", 10, 1), Err(Error::Call(_))));
}

#[cfg(feature = "proptest")]
mod drawn {
    use proptest::prelude::*;
    use proptest::test_runner::{Config, TestError, TestRunner};

    /// A fan about the first point: wrong for nearly all inputs.
    fn fan(points: &[[f64; 2]]) -> Vec<[usize; 3]> {
        (2..points.len()).map(|i| [0, i - 1, i]).collect()
    }

    #[test]
    fn a_wrong_program_is_found_and_its_input_shrinks() {
        let strategy = circumspect::strategies::points::<2>(&circumspect::strategies::FAMILIES, 20);
        let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::default() });
        let found = runner.run(&strategy, |points| {
            prop_assert!(circumspect::check("delaunay", &points, &fan(&points)).unwrap().holds);
            Ok(())
        });
        match found {
            Err(TestError::Fail(_, points)) => assert!(points.len() <= 4, "{points:?}"),
            other => panic!("expected a failure, found {other:?}"),
        }
    }
}
