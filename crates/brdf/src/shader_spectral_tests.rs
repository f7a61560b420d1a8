//! Spectral tables keep their values on the way to the GPU, and the uniform lies as it is documented.

use super::*;
use crate::front_factor::{Factor, FrontFactor};
use crate::spectral::{SpectralLobe, images_for};

/// Tables of 3 x 3 texels, each with a magnitude of its own; numbers as files of halves give them back.
fn tables(count: usize) -> SpectralTables {
    let half = |n: usize, row: usize, column: usize| {
        f16::from_f32(4001.0 / (1.0 + (9 * n + 3 * row + column) as f32)).to_f32() * 2f32.powi(-(n as i32))
    };
    let image = |i: usize| {
        Array3::from_shape_fn((3, 3, 3), |(row, column, c)| match TABLES_PER_IMAGE * i + c {
            n if n < count => half(n, row, column),
            _ => 0.0,
        })
    };
    SpectralTables {
        shortest_nm: 380.0,
        longest_nm: 780.0,
        count,
        images: (0..images_for(count)).map(image).collect(),
        lobe: None,
        prefilter_width: 0.0,
        front_factor: FrontFactor {
            material: Material::Dielectric { n: 1.5 },
            shadowing: false,
            factor: Factor::Vector,
        },
        dispersion: None,
        usable_radius: 2.0,
        sigma_nm: 5_000.0,
        half_height_range_nm: 100.0,
    }
}

#[test]
fn every_table_lies_in_its_channel_unchanged() {
    for count in [1, 3, 4, 5, 8, 11] {
        let tables = tables(count);
        let image = spectral_image(&tables).unwrap();
        assert_eq!(image.params.table_layers as usize, count.div_ceil(4));
        assert_eq!(image.tables.texels.len(), 9 * count.div_ceil(4));
        for n in 0..4 * count.div_ceil(4) {
            for at in 0..9 {
                let shown =
                    image.tables.texels[n / 4 * 9 + at][n % 4].to_f32() * image.params.table_scales[n / 4][n % 4];
                let value = if n < count { tables.images[n / 3][[at / 3, at % 3, n % 3]] } else { 0.0 };
                assert_eq!(shown, value, "table {n} of {count}, texel {at}");
            }
        }
    }
}

#[test]
fn a_long_lobe_goes_on_in_the_next_row() {
    let power: Vec<f32> = (0..5_000).map(|index| index as f32).collect();
    let lobe = |power: &[f32]| {
        Some(SpectralLobe { power: power.to_vec(), sigma_nm: 15_000.0, is_of_source: false, cross: None })
    };
    let image = spectral_image(&SpectralTables { lobe: lobe(&power), ..tables(2) }).unwrap();
    assert_eq!((image.power_size, image.params.lobe_count), ([2, 4096], 5_000));
    assert_eq!((image.power.len(), image.power[4_999], image.power[5_000]), (8_192, 4_999.0, 0.0));
    for bad in [&[1.0f32][..], &[1.0, f32::NAN]] {
        assert!(spectral_image(&SpectralTables { lobe: lobe(bad), ..tables(2) }).is_err());
    }
}

#[test]
fn what_no_shader_takes_is_refused() {
    assert!(spectral_image(&tables(256)).is_ok());
    assert!(spectral_image(&tables(257)).is_err());
    assert!(spectral_image(&SpectralTables { count: 0, ..tables(1) }).is_err());
    assert!(spectral_image(&SpectralTables { count: 4, ..tables(3) }).is_err());
    let mut broken = tables(3);
    broken.images[0][[1, 1, 2]] = f32::NAN;
    assert!(spectral_image(&broken).is_err());
}

#[test]
fn the_index_of_a_wavelength_is_put_into_the_uniform() {
    let params = spectral_image(&tables(1)).unwrap().params;
    assert_eq!((params.material, params.index_n, params.permittivity), (1, 1.5, [2.25, 0.0]));
    let metal = params.at(Material::Conductor { n: 0.5, k: 2.0 });
    assert_eq!((metal.material, metal.index_n, metal.index_k, metal.permittivity), (2, 0.5, 2.0, [-3.75, 2.0]));
    assert_eq!(metal.table_scales, params.table_scales);
    // A dispersion is asked at the shortest wavelength.
    let gold = crate::Dispersion::metal("gold").unwrap();
    let [n, k] = gold.index_at(380.0).unwrap().map(|x| x as f32);
    let params = spectral_image(&SpectralTables { dispersion: Some(gold), ..tables(1) }).unwrap().params;
    assert_eq!((params.material, params.index_n, params.index_k), (2, n, k));
}

#[test]
fn the_uniform_lies_as_its_table_says() {
    use std::mem::{offset_of, size_of};
    macro_rules! offsets {
        ($($field:ident)*) => { [$((stringify!($field), offset_of!(SpectralParams, $field))),*] };
    }
    let fields = offsets!(table_layers cross_layers lobe_count material factor shadowing index_n index_k permittivity
        shortest_nm lobe_sigma_nm cross_radius of_source look_up unused table_scales cross_scales);
    let cells = |line: &'static str| Some(line.strip_prefix("//! | ")?.split(" | ").collect::<Vec<_>>());
    let rows = include_str!("shader_spectral.rs").lines().filter_map(cells).filter(|cells| cells.len() == 4);
    let stated = rows.skip(1).flat_map(|cells| {
        let names = cells[2].split(", ").map(|name| name.trim_matches('`'));
        names.zip(cells[0].split(", ").map(|offset| offset.parse().unwrap())).collect::<Vec<_>>()
    });
    assert_eq!(stated.collect::<Vec<_>>(), fields);
    assert_eq!(size_of::<SpectralParams>(), 2112);
}
