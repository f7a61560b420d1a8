//! Animations and environments in a run: files, frames, report, inputs.

use diffraction_brdf::exr_image::{Precision, write_rgb};
use ndarray::Array3;

use crate::place::{HEAD, LASERS, Place, WAVE, contents};

const SCENE: &str = r#"[[scene]]
name = "ball"
shape = "sphere"
size_px = 32
environment = { file = "sky.exr", scale = 0.3 }
light = { direction = [0.3, 0.2, 1.0], angular_diameter_deg = 0 }
light_samples = 8
animate = { kind = "light", axis = "viewing", frames = 5, degrees = 360, fps = 10, size_px = 24 }
"#;

fn sky(place: &Place, value: f32) {
    let image = Array3::from_shape_fn((8, 16, 3), |(row, _, _)| if row < 4 { value } else { 0.1 });
    write_rgb(&place.path("sky.exr"), &image, Precision::Half, &serde_json::json!({})).unwrap();
}

#[test]
fn frames_and_skies_are_published_and_shown() {
    let place = Place::with_scans();
    sky(&place, 1.0);
    let text = format!("{HEAD}{LASERS}{WAVE}{SCENE}");
    place.publish(&text);
    let file = place.path("out/small/v0001/wave/scenes/ball.animated.png");
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(file).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let control = *reader.info().animation_control().unwrap();
    assert_eq!((control.num_frames, control.num_plays), (5, 0));
    let mut frames = Vec::new();
    for _ in 0..5 {
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let shown = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((shown.width, shown.height), (24, 24));
        let delay = reader.info().frame_control().unwrap();
        assert_eq!((delay.delay_num, delay.delay_den), (1, 10));
        frames.push(pixels);
    }
    assert!((0..5).all(|a| (0..a).all(|b| frames[a] != frames[b])), "every frame shows something else");
    let scene = &place.json("out/small/v0001/report.json")["specimens"][0]["scenes"][0];
    assert_eq!(scene["animation_png"], "wave/scenes/ball.animated.png");
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains("the light turns once round by 360° about the viewing axis, 5 frames"));
    let inputs = place.json("out/small/v0001/atlas.json")["inputs"].to_string();
    assert!(inputs.contains("sky.exr"), "{inputs}");

    // The same bytes on one thread: nothing is published. Another sky: another version.
    let first = contents(&place.path("out/small/v0001"));
    place.write("m.toml", &text);
    place.call("--quiet --threads 1 run m.toml").ended(0);
    assert_eq!(place.latest(), "v0001");
    sky(&place, 2.0);
    place.publish(&text);
    assert_eq!(place.latest(), "v0002");
    assert_ne!(
        first["wave/scenes/ball.animated.png"],
        contents(&place.path("out/small/v0002"))["wave/scenes/ball.animated.png"]
    );
}
