//! Refractive indices from the literature: wavelength in nm, `n`, `k`.
//!
//! The numbers are those of the publications named; of each table the part from the near ultraviolet to the near infrared.

/// A material of the literature.
pub(crate) struct BuiltIn {
    /// What manifests call it.
    pub name: &'static str,
    /// Where its numbers were published, and of what they were measured.
    pub citation: &'static str,
    /// The numbers.
    pub numbers: Numbers,
}

/// An index as it was published.
pub(crate) enum Numbers {
    /// `[wavelength_nm, n, k]`.
    Rows(&'static [[f64; 3]]),
    /// A formula for `n` at a wavelength in nm; nothing is absorbed.
    Formula {
        /// First and last wavelength for which it is taken, in nm.
        range_nm: [f64; 2],
        /// The formula.
        n: fn(f64) -> f64,
    },
}

const JOHNSON_1972: &str = "P. B. Johnson and R. W. Christy, Optical constants of the noble metals, Phys. Rev. B 6, 4370 (1972); \
                            evaporated films";
const JOHNSON_1974: &str = "P. B. Johnson and R. W. Christy, Optical constants of transition metals, Phys. Rev. B 9, 5056 (1974); \
                            evaporated films";

/// The metals, by name.
pub(crate) const METALS: [BuiltIn; 6] = [
    BuiltIn {
        name: "aluminium",
        citation: "A. D. Rakic, Algorithm for the determination of intrinsic optical constants of metal films: application to \
                   aluminum, Appl. Opt. 34, 4755 (1995); evaporated films without their oxide",
        numbers: Numbers::Rows(&ALUMINIUM),
    },
    BuiltIn { name: "chromium", citation: JOHNSON_1974, numbers: Numbers::Rows(&CHROMIUM) },
    BuiltIn { name: "copper", citation: JOHNSON_1972, numbers: Numbers::Rows(&COPPER) },
    BuiltIn { name: "gold", citation: JOHNSON_1972, numbers: Numbers::Rows(&GOLD) },
    BuiltIn { name: "nickel", citation: JOHNSON_1974, numbers: Numbers::Rows(&NICKEL) },
    BuiltIn { name: "silver", citation: JOHNSON_1972, numbers: Numbers::Rows(&SILVER) },
];

/// What was fitted to wavelengths from 400 to 600 nm, and is continued beyond.
const LEERTOUWER: &str = "H. L. Leertouwer, B. D. Wilts and D. G. Stavenga, Refractive index and dispersion of butterfly chitin and \
                          bird keratin measured by polarizing interference microscopy, Opt. Express 19, 24061 (2011)";

/// The rest.
pub(crate) const OTHERS: [BuiltIn; 4] = [
    BuiltIn {
        name: "beta_keratin",
        citation: LEERTOUWER,
        numbers: Numbers::Formula { range_nm: OBSERVER_NM, n: |nm| 1.532 + 5.89e3 / (nm * nm) },
    },
    BuiltIn {
        name: "chitin",
        citation: LEERTOUWER,
        numbers: Numbers::Formula { range_nm: OBSERVER_NM, n: |nm| 1.517 + 8.80e3 / (nm * nm) },
    },
    BuiltIn {
        name: "silica",
        citation: "I. H. Malitson, Interspecimen comparison of the refractive index of fused silica, J. Opt. Soc. Am. 55, 1205 \
                   (1965); at 20 degrees Celsius",
        numbers: Numbers::Formula { range_nm: [250.0, 2500.0], n: silica },
    },
    BuiltIn {
        name: "silicon",
        citation: "M. A. Green, Self-consistent optical parameters of intrinsic silicon at 300 K including temperature \
                   coefficients, Sol. Energy Mater. Sol. Cells 92, 1305 (2008); crystalline, without its oxide",
        numbers: Numbers::Rows(&SILICON),
    },
];

/// What the eye's observer is tabulated for.
const OBSERVER_NM: [f64; 2] = [360.0, 830.0];

/// Malitson's three terms of Sellmeier's formula.
fn silica(wavelength_nm: f64) -> f64 {
    const TERMS: [[f64; 2]; 3] = [[0.696_166_3, 0.068_404_3], [0.407_942_6, 0.116_241_4], [0.897_479_4, 9.896_161]];
    let um2 = (wavelength_nm * 1e-3).powi(2);
    (1.0 + TERMS.iter().map(|[strength, um]| strength * um2 / (um2 - um * um)).sum::<f64>()).sqrt()
}

/// Rakic 1995.
const ALUMINIUM: [[f64; 3]; 17] = [
    [309.96, 0.28003, 3.7081],
    [326.28, 0.31474, 3.9165],
    [364.66, 0.39877, 4.3957],
    [413.28, 0.52135, 5.0008],
    [442.8, 0.6079, 5.3676],
    [476.87, 0.7278, 5.7781],
    [516.6, 0.8734, 6.2418],
    [563.57, 1.0728, 6.7839],
    [619.93, 1.366, 7.4052],
    [652.25, 1.5724, 7.7354],
    [688.81, 1.8301, 8.0601],
    [729.32, 2.1606, 8.3565],
    [774.91, 2.6154, 8.4914],
    [794.78, 2.7675, 8.3866],
    [815.69, 2.7668, 8.2573],
    [837.74, 2.6945, 8.1878],
    [885.61, 2.2802, 8.1134],
];

/// Johnson and Christy 1974.
#[expect(clippy::approx_constant, reason = "measured, not the circle's")]
const CHROMIUM: [[f64; 3]; 23] = [
    [301.0, 1.53, 2.34],
    [311.0, 1.58, 2.4],
    [320.0, 1.65, 2.47],
    [332.0, 1.69, 2.53],
    [342.0, 1.76, 2.58],
    [354.0, 1.84, 2.64],
    [368.0, 1.87, 2.69],
    [381.0, 1.92, 2.74],
    [397.0, 2.0, 2.83],
    [413.0, 2.08, 2.93],
    [431.0, 2.19, 3.04],
    [451.0, 2.33, 3.14],
    [471.0, 2.51, 3.24],
    [496.0, 2.75, 3.3],
    [521.0, 2.94, 3.33],
    [549.0, 3.18, 3.33],
    [582.0, 3.22, 3.3],
    [617.0, 3.17, 3.3],
    [659.0, 3.09, 3.34],
    [704.0, 3.05, 3.39],
    [756.0, 3.08, 3.42],
    [821.0, 3.2, 3.48],
    [892.0, 3.3, 3.52],
];

/// Johnson and Christy 1972.
const COPPER: [[f64; 3]; 23] = [
    [300.9, 1.4, 1.679],
    [310.7, 1.38, 1.729],
    [320.4, 1.38, 1.783],
    [331.5, 1.34, 1.821],
    [342.5, 1.36, 1.864],
    [354.2, 1.37, 1.916],
    [367.9, 1.36, 1.975],
    [381.5, 1.33, 2.045],
    [397.4, 1.32, 2.116],
    [413.3, 1.28, 2.207],
    [430.5, 1.25, 2.305],
    [450.9, 1.24, 2.397],
    [471.4, 1.25, 2.483],
    [495.9, 1.22, 2.564],
    [520.9, 1.18, 2.608],
    [548.6, 1.02, 2.577],
    [582.1, 0.7, 2.704],
    [616.8, 0.3, 3.205],
    [659.5, 0.22, 3.747],
    [704.5, 0.21, 4.205],
    [756.0, 0.24, 4.665],
    [821.1, 0.26, 5.18],
    [892.0, 0.3, 5.768],
];

/// Johnson and Christy 1972.
const GOLD: [[f64; 3]; 23] = [
    [300.9, 1.53, 1.889],
    [310.7, 1.53, 1.893],
    [320.4, 1.54, 1.898],
    [331.5, 1.48, 1.883],
    [342.5, 1.48, 1.871],
    [354.2, 1.5, 1.866],
    [367.9, 1.48, 1.895],
    [381.5, 1.46, 1.933],
    [397.4, 1.47, 1.952],
    [413.3, 1.46, 1.958],
    [430.5, 1.45, 1.948],
    [450.9, 1.38, 1.914],
    [471.4, 1.31, 1.849],
    [495.9, 1.04, 1.833],
    [520.9, 0.62, 2.081],
    [548.6, 0.43, 2.455],
    [582.1, 0.29, 2.863],
    [616.8, 0.21, 3.272],
    [659.5, 0.14, 3.697],
    [704.5, 0.13, 4.103],
    [756.0, 0.14, 4.542],
    [821.1, 0.16, 5.083],
    [892.0, 0.17, 5.663],
];

/// Johnson and Christy 1974.
const NICKEL: [[f64; 3]; 23] = [
    [301.0, 2.02, 2.18],
    [311.0, 2.01, 2.18],
    [320.0, 1.93, 2.19],
    [332.0, 1.84, 2.22],
    [342.0, 1.78, 2.26],
    [354.0, 1.74, 2.32],
    [368.0, 1.7, 2.4],
    [381.0, 1.72, 2.48],
    [397.0, 1.72, 2.57],
    [413.0, 1.7, 2.69],
    [431.0, 1.71, 2.82],
    [451.0, 1.73, 2.95],
    [471.0, 1.78, 3.09],
    [496.0, 1.82, 3.25],
    [521.0, 1.85, 3.42],
    [549.0, 1.92, 3.61],
    [582.0, 1.96, 3.8],
    [617.0, 1.99, 4.02],
    [659.0, 1.99, 4.26],
    [704.0, 2.06, 4.5],
    [756.0, 2.13, 4.73],
    [821.0, 2.26, 4.97],
    [892.0, 2.4, 5.23],
];

/// Johnson and Christy 1972.
const SILVER: [[f64; 3]; 23] = [
    [300.9, 1.34, 0.964],
    [310.7, 1.13, 0.616],
    [320.4, 0.81, 0.392],
    [331.5, 0.17, 0.829],
    [342.5, 0.14, 1.142],
    [354.2, 0.1, 1.419],
    [367.9, 0.07, 1.657],
    [381.5, 0.05, 1.864],
    [397.4, 0.05, 2.07],
    [413.3, 0.05, 2.275],
    [430.5, 0.04, 2.462],
    [450.9, 0.04, 2.657],
    [471.4, 0.05, 2.869],
    [495.9, 0.05, 3.093],
    [520.9, 0.05, 3.324],
    [548.6, 0.06, 3.586],
    [582.1, 0.05, 3.858],
    [616.8, 0.06, 4.152],
    [659.5, 0.05, 4.483],
    [704.5, 0.04, 4.838],
    [756.0, 0.03, 5.242],
    [821.1, 0.04, 5.727],
    [892.0, 0.04, 6.312],
];

/// Green 2008.
const SILICON: [[f64; 3]; 61] = [
    [300.0, 4.976, 4.234],
    [310.0, 5.121, 3.598],
    [320.0, 5.112, 3.303],
    [330.0, 5.195, 3.1],
    [340.0, 5.301, 2.977],
    [350.0, 5.494, 2.938],
    [360.0, 6.026, 2.966],
    [370.0, 6.891, 2.171],
    [380.0, 6.616, 0.946],
    [390.0, 6.039, 0.445],
    [400.0, 5.613, 0.296],
    [410.0, 5.33, 0.227],
    [420.0, 5.119, 0.176],
    [430.0, 4.949, 0.138],
    [440.0, 4.812, 0.107],
    [450.0, 4.691, 0.086302],
    [460.0, 4.587, 0.071381],
    [470.0, 4.497, 0.062086],
    [480.0, 4.419, 0.055004],
    [490.0, 4.35, 0.049131],
    [500.0, 4.294, 0.044165],
    [510.0, 4.241, 0.039367],
    [520.0, 4.193, 0.036415],
    [530.0, 4.151, 0.033108],
    [540.0, 4.112, 0.030295],
    [550.0, 4.077, 0.027968],
    [560.0, 4.045, 0.025758],
    [570.0, 4.015, 0.024131],
    [580.0, 3.988, 0.022524],
    [590.0, 3.963, 0.021081],
    [600.0, 3.94, 0.019934],
    [610.0, 3.918, 0.018446],
    [620.0, 3.898, 0.017367],
    [630.0, 3.879, 0.016444],
    [640.0, 3.861, 0.015432],
    [650.0, 3.844, 0.014431],
    [660.0, 3.828, 0.013498],
    [670.0, 3.813, 0.012743],
    [680.0, 3.798, 0.011905],
    [690.0, 3.784, 0.011201],
    [700.0, 3.772, 0.010528],
    [710.0, 3.759, 0.010057],
    [720.0, 3.748, 0.0096257],
    [730.0, 3.737, 0.0089461],
    [740.0, 3.727, 0.008362],
    [750.0, 3.717, 0.0078185],
    [760.0, 3.708, 0.007197],
    [770.0, 3.699, 0.0067402],
    [780.0, 3.691, 0.0063933],
    [790.0, 3.683, 0.005834],
    [800.0, 3.675, 0.0054113],
    [810.0, 3.668, 0.0049955],
    [820.0, 3.661, 0.0046134],
    [830.0, 3.654, 0.0042734],
    [840.0, 3.647, 0.0039439],
    [850.0, 3.641, 0.003612],
    [860.0, 3.635, 0.0032781],
    [870.0, 3.63, 0.0029839],
    [880.0, 3.624, 0.0026821],
    [890.0, 3.619, 0.0024293],
    [900.0, 3.614, 0.0021701],
];
