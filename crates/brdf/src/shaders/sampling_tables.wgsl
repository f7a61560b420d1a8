// Directions drawn from the tables, and the mixture: `brdf_sample` and `brdf_pdf`. Follows sampling.wgsl.
//
// For a viewer, directions to the light fill the disc of radius 1 about -wo in (u, v). A band of rows of cells is chosen in proportion to the
// tables within its widest chord of that disc, a row likewise, v evenly in the row, and u within the chord at v: in pieces that
// narrow towards its ends by a factor of four, within which the cosine varies by two.

// Pieces of a chord.
const PIECES: i32 = 12;

// A direction to the light in xyz, drawn for one to the viewer by three even random numbers in [0, 1), and its density in 1/sr in w; zeros where
// the viewer is not above the surface or nothing was found to draw. A sample's weight is brdf_xyz(wi, wo) * wi.z / w, and bounded.
fn brdf_sample(wo: vec3<f32>, u: vec3<f32>) -> vec4<f32> {
    if !(wo.z > 0.0) {
        return vec4<f32>(0.0, 0.0, 0.0, 0.0);
    }
    let node = node_of(wo.z);
    let even = number(0, FIRST_NODE + node);
    var wi: vec3<f32>;
    if u.x < even {
        // A quarter turn at a time.
        let quarter = floor(4.0 * u.z + 0.5);
        let place = sine_and_cosine((4.0 * u.z - quarter) * HALF_PI);
        var at = vec2<f32>(place.y, place.x);
        for (var k = 0.0; k < quarter; k = k + 1.0) {
            at = vec2<f32>(-at.y, at.x);
        }
        wi = vec3<f32>(sqrt(max(1.0 - u.y * u.y, 0.0)) * at, u.y);
    } else if u.x < even + number(1, FIRST_NODE + node) {
        wi = sample_lobe(node, wo, u.yz);
    } else {
        wi = sample_tables(node, wo, u.yz);
    }
    let density = brdf_pdf(wi, wo);
    return select(vec4<f32>(0.0, 0.0, 0.0, 0.0), vec4<f32>(wi, density), density > 0.0);
}

// Density in 1/sr with which brdf_sample draws wi; 0 for directions not above the surface.
fn brdf_pdf(wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return 0.0;
    }
    let node = node_of(wo.z);
    let shares = vec3<f32>(number(0, FIRST_NODE + node), number(1, FIRST_NODE + node), number(2, FIRST_NODE + node));
    var density = shares.x / (4.0 * HALF_PI);
    if shares.y > 0.0 {
        density = density + shares.y * pdf_lobe(node, wi, wo);
    }
    if shares.z > 0.0 {
        density = density + shares.z * pdf_tables(node, wi, wo);
    }
    return density;
}

// The grid of cells, and what of it one viewer sees.
struct Cells {
    // u of the left edge, v of the upper one; a cell's side.
    first: vec2<f32>,
    side: f32,
    rows: i32,
    columns: i32,
    // Rows of a band.
    band: i32,
    // Where this node's sums along rows begin.
    sums: i32,
    wo: vec2<f32>,
    // Places between rows, from the top, between which the viewer's disc lies.
    seen: vec2<f32>,
}

fn cells_for(node: i32, wo: vec3<f32>) -> Cells {
    let first = vec2<f32>(number(0, 0), number(1, 0));
    let side = number(2, 0);
    let rows = i32(number(3, 0));
    let band = i32(number(5, 0));
    let bands = (rows + band - 1) / band;
    let seen = clamp((first.y + wo.y + vec2<f32>(-1.0, 1.0)) / side, vec2<f32>(0.0, 0.0), vec2<f32>(f32(rows), f32(rows)));
    return Cells(first, side, rows, i32(number(4, 0)), band, FIRST_SUM + node * (rows + bands), wo.xy, seen);
}

// A place along a row of sums: the cell, the share of it, and the sums at its edges.
struct Place {
    cell: i32,
    share: f32,
    before: f32,
    after: f32,
}

fn place_in(cells: Cells, row: i32, x: f32) -> Place {
    let at = clamp(x, 0.0, f32(cells.columns));
    let cell = min(i32(at), cells.columns - 1);
    return Place(cell, at - f32(cell), number(cell, row), number(cell + 1, row));
}

// The sum between two places that lie so many cells apart: of parts that are not negative, so that nothing cancels.
fn sum_between(low: Place, high: Place, apart: f32) -> f32 {
    if low.cell == high.cell {
        return apart * (low.after - low.before);
    }
    let ends = (1.0 - low.share) * (low.after - low.before) + high.share * (high.after - high.before);
    return ends + (high.before - low.after);
}

// The chord at a component wi.y: half of it, and the shares of that half between which the grid lies.
fn chord_ends(cells: Cells, wi_y: f32) -> vec3<f32> {
    let half_chord = sqrt(max((1.0 - wi_y) * (1.0 + wi_y), 0.0));
    if half_chord == 0.0 {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let left = cells.first.x + cells.wo.x;
    let low = max(left / half_chord, -1.0);
    let high = min((left + f32(cells.columns) * cells.side) / half_chord, 1.0);
    return vec3<f32>(half_chord, low, max(low, high));
}

// Where in a row -wi.x = s lies.
fn column_of(cells: Cells, s: f32) -> f32 {
    return (s - cells.wo.x - cells.first.x) / cells.side;
}

// Angle whose sine is a share of half a chord.
fn angle_of(share: f32) -> f32 {
    return angle_from_z(share, sqrt(max((1.0 - share) * (1.0 + share), 0.0)));
}

// What of some rows the viewer sees: `height` rows each, whose sums follow one another from `base` on.
fn masses_of(cells: Cells, first: i32, count: i32, height: i32, base: i32) -> Masses {
    var masses: Masses;
    let middle = (cells.first.y + cells.wo.y) / cells.side;
    for (var k = 0; k < count; k = k + 1) {
        let reach = overlap(cells, (first + k) * height, height);
        if !(reach.y > reach.x) {
            continue;
        }
        // The place that lies nearest to the disc's middle.
        let ends = chord_ends(cells, clamp(middle, reach.x, reach.y) * cells.side - cells.first.y - cells.wo.y);
        if !(ends.z > ends.y) {
            continue;
        }
        let row = base + first + k;
        let low = place_in(cells, row, column_of(cells, ends.x * ends.y));
        let high = place_in(cells, row, column_of(cells, ends.x * ends.z));
        let apart = (ends.z - ends.y) * ends.x;
        let sum = sum_between(low, high, apart / cells.side);
        masses.each[k] = sum * (angle_of(ends.z) - angle_of(ends.y)) / apart * (reach.y - reach.x);
    }
    return masses;
}

// Where `count` rows from `first` on overlap with what is seen.
fn overlap(cells: Cells, first: i32, count: i32) -> vec2<f32> {
    return vec2<f32>(max(f32(first), cells.seen.x), min(f32(first + count), cells.seen.y));
}

// First and number of the bands that the viewer sees.
fn bands_seen(cells: Cells) -> vec2<i32> {
    let rows = min(vec2<i32>(cells.seen), vec2<i32>(cells.rows - 1, cells.rows - 1)) / cells.band;
    return vec2<i32>(rows.x, rows.y + 1 - rows.x);
}

// First and number of the rows of a band that it sees.
fn rows_seen(cells: Cells, band: i32) -> vec2<i32> {
    let first = max(band * cells.band, i32(cells.seen.x));
    let end = min(min((band + 1) * cells.band, cells.rows), i32(cells.seen.y) + 1);
    return vec2<i32>(first, max(end - first, 0));
}

fn band_masses(cells: Cells, bands: vec2<i32>) -> Masses {
    return masses_of(cells, bands.x, bands.y, cells.band, cells.sums + cells.rows);
}

fn row_masses(cells: Cells, rows: vec2<i32>) -> Masses {
    return masses_of(cells, rows.x, rows.y, 1, cells.sums);
}

// A chord in pieces: shares of half of it at their edges, the angles with these sines, sums, and masses. Even where all cells are 0.
struct Chord {
    half_chord: f32,
    is_even: bool,
    shares: array<f32, 13>,
    angles: array<f32, 13>,
    sums: array<f32, 32>,
    masses: Masses,
}

// Edge of a piece as a share of half a chord: 1 - 4^-k from the middle on, and 1.
fn edge_share(k: i32) -> f32 {
    let from_middle = abs(k - PIECES / 2);
    var rest = 1.0;
    for (var n = 0; n < from_middle; n = n + 1) {
        rest = 0.25 * rest;
    }
    let share = select(1.0 - rest, 1.0, from_middle == PIECES / 2);
    return select(share, -share, k < PIECES / 2);
}

fn chord_at(cells: Cells, row: i32, wi_y: f32) -> Chord {
    let ends = chord_ends(cells, wi_y);
    var chord: Chord;
    chord.half_chord = ends.x;
    var total = 0.0;
    var low = place_in(cells, cells.sums + row, column_of(cells, ends.x * ends.y));
    chord.shares[0] = ends.y;
    chord.angles[0] = angle_of(ends.y);
    for (var k = 0; k < PIECES; k = k + 1) {
        let share = clamp(edge_share(k + 1), ends.y, ends.z);
        let high = place_in(cells, cells.sums + row, column_of(cells, ends.x * share));
        chord.shares[k + 1] = share;
        chord.angles[k + 1] = angle_of(share);
        let width = (share - chord.shares[k]) * ends.x;
        if width > 0.0 {
            chord.sums[k] = sum_between(low, high, width / cells.side);
            chord.masses.each[k] = chord.sums[k] * (chord.angles[k + 1] - chord.angles[k]) / width;
        }
        total = total + chord.sums[k];
        low = high;
    }
    chord.is_even = !(total > 0.0);
    if chord.is_even {
        for (var k = 0; k < PIECES; k = k + 1) {
            chord.masses.each[k] = chord.angles[k + 1] - chord.angles[k];
        }
    }
    return chord;
}

fn is_even_piece(piece: i32, all_even: bool) -> bool {
    return all_even || piece == 0 || piece == PIECES - 1;
}

// The place along a row from a place on at which so much has been summed up.
fn place_of_sum(cells: Cells, row: i32, start: f32, sum: f32) -> f32 {
    let from_place = place_in(cells, row, start);
    let wanted = from_place.before + from_place.share * (from_place.after - from_place.before) + sum;
    var low = from_place.cell;
    var high = cells.columns;
    while high - low > 1 {
        let middle = (low + high) / 2;
        if number(middle, row) <= wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    let below = number(low, row);
    let above = number(low + 1, row);
    if above > below {
        return f32(low) + clamp((wanted - below) / (above - below), 0.0, 1.0);
    }
    return f32(low);
}

// A direction drawn from the tables; 0 where there is none.
fn sample_tables(node: i32, wo: vec3<f32>, u: vec2<f32>) -> vec3<f32> {
    let cells = cells_for(node, wo);
    let bands = bands_seen(cells);
    let band = choose(band_masses(cells, bands), bands.y, u.x);
    let rows = rows_seen(cells, bands.x + band.index);
    let chosen = choose(row_masses(cells, rows), rows.y, band.rest);
    let row = rows.x + chosen.index;
    let reach = overlap(cells, row, 1);
    if !(cells.seen.y - cells.seen.x > 1e-6 && reach.y > reach.x) {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let wi_y = mix(reach.x, reach.y, chosen.rest) * cells.side - cells.first.y - wo.y;
    var chord = chord_at(cells, row, wi_y);
    let piece = choose(chord.masses, PIECES, u.y);
    let first = piece.index;
    if is_even_piece(first, chord.is_even) {
        let place = sine_and_cosine(mix(chord.angles[first], chord.angles[first + 1], piece.rest));
        return vec3<f32>(-chord.half_chord * place.x, wi_y, chord.half_chord * place.y);
    }
    let edges = chord.half_chord * vec2<f32>(chord.shares[first], chord.shares[first + 1]);
    let start = column_of(cells, edges.x);
    let x = place_of_sum(cells, cells.sums + row, start, piece.rest * chord.sums[first]);
    let s = clamp(cells.first.x + x * cells.side + wo.x, edges.x, edges.y);
    return vec3<f32>(-s, wi_y, sqrt(max((chord.half_chord - s) * (chord.half_chord + s), 0.0)));
}

// Density of sample_tables in 1/sr.
fn pdf_tables(node: i32, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let cells = cells_for(node, wo);
    let x = column_of(cells, -wi.x);
    let at = (cells.first.y + wi.y + wo.y) / cells.side;
    let is_inside = x >= 0.0 && x < f32(cells.columns) && at >= 0.0 && at < f32(cells.rows);
    if !(is_inside && cells.seen.y - cells.seen.x > 1e-6) {
        return 0.0;
    }
    let row = i32(at);
    let bands = bands_seen(cells);
    let rows = rows_seen(cells, row / cells.band);
    let reach = overlap(cells, row, 1);
    let band_index = row / cells.band - bands.x;
    let is_seen = band_index >= 0 && band_index < bands.y && row >= rows.x && row < rows.x + rows.y;
    if !(is_seen && reach.y > reach.x) {
        return 0.0;
    }
    let down = probability_of(band_masses(cells, bands), bands.y, band_index)
        * probability_of(row_masses(cells, rows), rows.y, row - rows.x) / (reach.y - reach.x);
    var chord = chord_at(cells, row, wi.y);
    var piece = 0;
    while piece < PIECES - 1 && chord.shares[piece + 1] * chord.half_chord <= -wi.x {
        piece = piece + 1;
    }
    let width = chord.angles[piece + 1] - chord.angles[piece];
    if !(chord.masses.each[piece] > 0.0 && width > 0.0) {
        return 0.0;
    }
    var along = 1.0 / width;
    if !is_even_piece(piece, chord.is_even) {
        let cell = place_in(cells, cells.sums + row, x);
        along = (cell.after - cell.before) / chord.sums[piece] / cells.side * wi.z;
    }
    return along * probability_of(chord.masses, PIECES, piece) * down / cells.side;
}
