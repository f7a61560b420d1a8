//! TIFFs laid out by hand, for what no encoder writes.

#![allow(dead_code)] // Each test program uses its own part.

/// Field types of TIFF.
pub const BYTE: u16 = 1;
pub const ASCII: u16 = 2;
pub const SHORT: u16 = 3;
pub const LONG: u16 = 4;
pub const RATIONAL: u16 = 5;
pub const UNDEFINED: u16 = 7;
pub const DOUBLE: u16 = 12;

/// Byte order of a file under construction.
#[derive(Clone, Copy, PartialEq)]
pub enum Order {
    Little,
    Big,
}

impl Order {
    /// An unsigned number in `size` bytes.
    pub fn bytes(self, number: u64, size: usize) -> Vec<u8> {
        match self {
            Self::Little => number.to_le_bytes()[..size].to_vec(),
            Self::Big => number.to_be_bytes()[8 - size..].to_vec(),
        }
    }
}

/// One tag: number, type, count and value bytes.
pub type Tag = (u16, u16, u32, Vec<u8>);

/// A page: its tags without 273 and 279, and its one strip.
#[derive(Clone, Default)]
pub struct PageParts {
    pub tags: Vec<Tag>,
    pub data: Vec<u8>,
    /// Value of tag 279; `None` leaves the tag out.
    pub byte_count: Option<u32>,
}

impl PageParts {
    /// A grey page of `bits` per sample in TIFF sample format `format`.
    pub fn grey(order: Order, [nx, ny]: [u32; 2], bits: u16, format: u16, data: Vec<u8>) -> Self {
        let mut page = Self { byte_count: Some(data.len() as u32), data, ..Self::default() };
        page.long(order, 256, nx);
        page.long(order, 257, ny);
        for (tag, value) in [(258, bits), (259, 1), (262, 1), (277, 1), (339, format)] {
            page.short(order, tag, value);
        }
        page.long(order, 278, ny);
        page
    }

    pub fn short(&mut self, order: Order, tag: u16, value: u16) {
        self.set((tag, SHORT, 1, order.bytes(u64::from(value), 2)));
    }

    pub fn long(&mut self, order: Order, tag: u16, value: u32) {
        self.set((tag, LONG, 1, order.bytes(u64::from(value), 4)));
    }

    pub fn double(&mut self, order: Order, tag: u16, value: f64) {
        self.set((tag, DOUBLE, 1, order.bytes(value.to_bits(), 8)));
    }

    pub fn rational(&mut self, order: Order, tag: u16, value: [u32; 2]) {
        let bytes = value.iter().flat_map(|&part| order.bytes(u64::from(part), 4));
        self.set((tag, RATIONAL, 1, bytes.collect()));
    }

    pub fn text(&mut self, tag: u16, text: &str) {
        let mut bytes = text.as_bytes().to_vec();
        bytes.push(0);
        self.set((tag, ASCII, bytes.len() as u32, bytes));
    }

    pub fn raw(&mut self, tag: u16, kind: u16, bytes: &[u8]) {
        self.set((tag, kind, bytes.len() as u32, bytes.to_vec()));
    }

    fn set(&mut self, tag: Tag) {
        self.tags.retain(|other| other.0 != tag.0);
        self.tags.push(tag);
    }
}

/// A classic TIFF with these pages. Header, then for each page: directory, long values, strip.
pub fn tiff_file(order: Order, pages: &[PageParts]) -> Vec<u8> {
    let mut file = match order {
        Order::Little => b"II".to_vec(),
        Order::Big => b"MM".to_vec(),
    };
    file.extend(order.bytes(42, 2));
    let mut link_at = file.len();
    file.extend([0; 4]);
    for page in pages {
        let start = file.len() + file.len() % 2;
        file.resize(start, 0);
        file[link_at..link_at + 4].copy_from_slice(&order.bytes(start as u64, 4));
        link_at = append_page(&mut file, order, page);
    }
    file
}

/// Appends a page; returns where the link to the next one is.
fn append_page(file: &mut Vec<u8>, order: Order, page: &PageParts) -> usize {
    let mut tags = page.tags.clone();
    let tiled = tags.iter().any(|tag| tag.0 == 324);
    let mut values_at = file.len() + 2 + 12 * tags.len() + 4;
    values_at += if tiled { 0 } else { 12 } + if page.byte_count.is_some() { 12 } else { 0 };
    let long_values: usize = tags.iter().map(|tag| tag.3.len()).filter(|&size| size > 4).sum();
    if !tiled {
        let data_at = (values_at + long_values) as u64;
        tags.push((273, LONG, 1, order.bytes(data_at, 4)));
    }
    if let Some(count) = page.byte_count {
        tags.push((279, LONG, 1, order.bytes(u64::from(count), 4)));
    }
    tags.sort_by_key(|tag| tag.0);
    let mut values: Vec<u8> = Vec::new();
    file.extend(order.bytes(tags.len() as u64, 2));
    for (tag, kind, count, bytes) in &tags {
        file.extend(order.bytes(u64::from(*tag), 2));
        file.extend(order.bytes(u64::from(*kind), 2));
        file.extend(order.bytes(u64::from(*count), 4));
        if bytes.len() <= 4 {
            file.extend(bytes);
            file.extend(vec![0; 4 - bytes.len()]);
        } else {
            file.extend(order.bytes((values_at + values.len()) as u64, 4));
            values.extend(bytes);
        }
    }
    let link_at = file.len();
    file.extend([0; 4]);
    file.extend(values);
    file.extend(&page.data);
    link_at
}

/// 32-bit floats in a byte order.
pub fn f32_bytes(order: Order, values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| order.bytes(u64::from(value.to_bits()), 4)).collect()
}
