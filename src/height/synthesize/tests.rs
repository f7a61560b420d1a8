use super::*;

#[test]
fn placeholder_removed_below() {
    assert!(synthesize(&Structure::Flat, [1, 1], [1.0; 2]).is_ok());
}
