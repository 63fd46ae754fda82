// SPDX-License-Identifier: Apache-2.0
//! libpsc for Rust: the declarations as bindgen would write them, and a safe wrapper.
//!
//! ```ignore
//! let mut sampler = psc::Sampler::new();
//! let technique = psc::Technique::new(psc::Measure::ProjectedSolidAngle, psc::Map::Radial);
//! let from = psc::Receiver::surface([0.0; 3], [0.0, 0.0, 1.0]);
//! let light = psc::Light::Sphere { center: [2.0, 1.0, 0.5], radius: 0.75 };
//! if let Some(built) = sampler.build(&technique, &from, &light)? {
//!     let s = built.sample(0.25, 0.75);
//! }
//! ```
//!
//! What is built borrows the sampler, so that it cannot change while it is sampled, and may be
//! shared between threads.
#![allow(dead_code)]

use std::ffi::CStr;
use std::fmt;

/// The C interface.
pub mod sys {
    use std::os::raw::{c_char, c_void};

    #[repr(C)]
    pub struct Sampler {
        _opaque: [u8; 0],
    }
    #[repr(C)]
    pub struct Table {
        _opaque: [u8; 0],
    }
    #[repr(C)]
    pub struct Technique {
        pub struct_size: u32,
        pub measure: u32,
        pub map: u32,
        pub flags: u32,
        pub table: *const Table,
    }
    #[repr(C)]
    pub struct Receiver {
        pub struct_size: u32,
        pub flags: u32,
        pub position: *const f64,
        pub normal: *const f64,
    }
    #[repr(C)]
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct Sample {
        pub direction: [f64; 3],
        pub pdf: f64,
        pub point: [f64; 3],
        pub distance: f64,
        pub normal: [f64; 3],
        pub weight: f64,
        pub surface: [f64; 2],
    }
    #[repr(C)]
    #[derive(Clone, Copy)]
    pub struct Input {
        pub component: [*const f64; 3],
        pub stride: isize,
    }
    #[repr(C)]
    pub struct Output {
        pub component: [*mut f64; 3],
        pub stride: isize,
    }
    #[repr(C)]
    pub struct OutputResult {
        pub data: *mut i32,
        pub stride: isize,
    }
    #[repr(C)]
    pub struct Samples {
        pub struct_size: u32,
        pub reserved: u32,
        pub direction: Output,
        pub pdf: Output,
        pub point: Output,
        pub distance: Output,
        pub normal: Output,
        pub weight: Output,
        pub surface: Output,
        pub status: OutputResult,
    }

    #[repr(C)]
    pub struct Receivers {
        pub struct_size: u32,
        pub flags: u32,
        pub position: Input,
        pub normal: Input,
    }

    // The calls that every shape has: build and wavefront.
    macro_rules! shapes {
        ($($build:ident, $sample_n:ident: $($part:ident: $number:ty),*;)*) => {
            #[link(name = "psc")]
            extern "C" {
                $(pub fn $build(
                    sampler: *mut Sampler,
                    technique: *const Technique,
                    receiver: *const Receiver,
                    $($part: $number),*
                ) -> i32;
                pub fn $sample_n(
                    technique: *const Technique,
                    count: usize,
                    receivers: *const Receivers,
                    $($part: *const Input,)*
                    uv: *const Input,
                    out: *const Samples,
                ) -> i32;)*
            }
        };
    }
    shapes! {
        psc_build_sphere, psc_sphere_sample_n_f64: center: *const f64, radius: f64;
        psc_build_cap, psc_cap_sample_n_f64: axis: *const f64, half_angle: f64;
        psc_build_disk, psc_disk_sample_n_f64:
            center: *const f64, normal: *const f64, radius: f64;
        psc_build_ellipse, psc_ellipse_sample_n_f64:
            center: *const f64, axis_u: *const f64, axis_v: *const f64;
        psc_build_ellipsoid, psc_ellipsoid_sample_n_f64:
            center: *const f64, axis_u: *const f64, axis_v: *const f64, axis_w: *const f64;
        psc_build_triangle, psc_triangle_sample_n_f64:
            v0: *const f64, v1: *const f64, v2: *const f64;
        psc_build_rectangle, psc_rectangle_sample_n_f64:
            corner: *const f64, edge_u: *const f64, edge_v: *const f64;
    }

    #[link(name = "psc")]
    extern "C" {
        pub fn psc_version() -> u32;
        pub fn psc_result_string(result: i32) -> *const c_char;
        pub fn psc_sampler_create(allocator: *const c_void, out: *mut *mut Sampler) -> i32;
        pub fn psc_sampler_destroy(sampler: *mut Sampler);
        pub fn psc_build_polygon(
            sampler: *mut Sampler,
            technique: *const Technique,
            receiver: *const Receiver,
            count: usize,
            vertices: *const f64,
            stride: isize,
        ) -> i32;
        pub fn psc_polygon_sample_n_f64(
            technique: *const Technique,
            count: usize,
            receivers: *const Receivers,
            vertex_count: usize,
            vertices: *const Input,
            uv: *const Input,
            out: *const Samples,
        ) -> i32;
        pub fn psc_sample_f64(sampler: *const Sampler, u: f64, v: f64, out: *mut Sample) -> i32;
        pub fn psc_pdf_f64(sampler: *const Sampler, direction: *const f64, out: *mut f64) -> i32;
        pub fn psc_invert_f64(sampler: *const Sampler, direction: *const f64, uv: *mut f64) -> i32;
        pub fn psc_sample_n_f64(
            sampler: *const Sampler,
            count: usize,
            uv: *const Input,
            out: *const Samples,
        ) -> i32;
        pub fn psc_table_size(resolution: u32) -> usize;
        pub fn psc_table_init(
            memory: *mut c_void,
            size: usize,
            resolution: u32,
            out: *mut *const Table,
        ) -> i32;
        pub fn psc_sampler_total(sampler: *const Sampler, out: *mut f64) -> i32;
        pub fn psc_sampler_solid_angle(sampler: *const Sampler, out: *mut f64) -> i32;
        pub fn psc_sampler_projected_solid_angle(sampler: *const Sampler, out: *mut f64) -> i32;
        pub fn psc_sampler_form_factor(sampler: *const Sampler, out: *mut f64) -> i32;
        pub fn psc_sampler_area(sampler: *const Sampler, out: *mut f64) -> i32;
    }
}

pub use sys::Sample;

pub const EMPTY: i32 = 1;

#[derive(Clone, Copy, PartialEq)]
pub enum Measure {
    SolidAngle = 0,
    ProjectedSolidAngle = 1,
    Area = 2,
    VisibleArea = 3,
}

#[derive(Clone, Copy, PartialEq)]
pub enum Map {
    Radial = 0,
    Parallel = 1,
    Concentric = 2,
    QuasiUniform = 3,
    Tabulated = 4,
}

/// What the tabulated map looks up.
pub struct Table {
    _memory: Box<[u32]>,
    handle: *const sys::Table,
}

// It is only read once it is made.
unsafe impl Send for Table {}
unsafe impl Sync for Table {}

impl Table {
    pub fn new(resolution: u32) -> Result<Self, Error> {
        let size = unsafe { sys::psc_table_size(resolution) };
        let mut memory = vec![0u32; (size + 3) / 4].into_boxed_slice();
        let (first, mut handle) = (memory.as_mut_ptr() as *mut _, std::ptr::null());
        match unsafe { sys::psc_table_init(first, size, resolution, &mut handle) } {
            0 => Ok(Table { _memory: memory, handle }),
            error => Err(Error(error)),
        }
    }
}

#[derive(Clone, Copy)]
pub struct Technique<'t> {
    pub measure: Measure,
    pub map: Map,
    pub one_sided: bool,
    pub table: Option<&'t Table>,
}

impl<'t> Technique<'t> {
    pub fn new(measure: Measure, map: Map) -> Self {
        Technique { measure, map, one_sided: false, table: None }
    }

    pub fn tabulated(table: &'t Table) -> Self {
        Technique { table: Some(table), ..Self::new(Measure::SolidAngle, Map::Tabulated) }
    }

    fn borrow(&self) -> sys::Technique {
        sys::Technique {
            struct_size: std::mem::size_of::<sys::Technique>() as u32,
            measure: self.measure as u32,
            map: self.map as u32,
            flags: self.one_sided as u32,
            table: self.table.map_or(std::ptr::null(), |t| t.handle),
        }
    }
}

/// The point that is lit.
#[derive(Clone, Copy)]
pub struct Receiver {
    pub position: [f64; 3],
    pub normal: Option<[f64; 3]>,
    pub two_sided: bool,
}

impl Receiver {
    pub fn surface(position: [f64; 3], normal: [f64; 3]) -> Self {
        Receiver { position, normal: Some(normal), two_sided: false }
    }
    pub fn volume(position: [f64; 3]) -> Self {
        Receiver { position, normal: None, two_sided: false }
    }
}

pub type Vector = [f64; 3];

#[derive(Clone, Copy)]
pub enum Light<'a> {
    Sphere { center: Vector, radius: f64 },
    Cap { axis: Vector, half_angle: f64 },
    Disk { center: Vector, normal: Vector, radius: f64 },
    Ellipse { center: Vector, axis_u: Vector, axis_v: Vector },
    Ellipsoid { center: Vector, axis_u: Vector, axis_v: Vector, axis_w: Vector },
    Triangle { v0: Vector, v1: Vector, v2: Vector },
    Rectangle { corner: Vector, edge_u: Vector, edge_v: Vector },
    Polygon { vertices: &'a [Vector] },
}

/// An error of the library, by its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error(pub i32);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The library returns a static string for every number.
        let words = unsafe { CStr::from_ptr(sys::psc_result_string(self.0)) };
        f.write_str(&words.to_string_lossy())
    }
}

impl std::error::Error for Error {}

/// Room for one light seen from one receiver.
pub struct Sampler {
    handle: *mut sys::Sampler,
}

// Nothing in a sampler belongs to a thread, and sampling does not change it.
unsafe impl Send for Sampler {}
unsafe impl Sync for Sampler {}

impl Sampler {
    /// Panics when memory runs out, as Box does.
    pub fn new() -> Self {
        let mut handle = std::ptr::null_mut();
        let result = unsafe { sys::psc_sampler_create(std::ptr::null(), &mut handle) };
        assert!(result == 0, "{}", Error(result));
        Sampler { handle }
    }

    /// None if nothing of the light can be seen.
    pub fn build<'s, 't: 's>(
        &'s mut self,
        technique: &Technique<'t>,
        receiver: &Receiver,
        light: &Light,
    ) -> Result<Option<Built<'s>>, Error> {
        let technique = technique.borrow();
        let from = sys::Receiver {
            struct_size: std::mem::size_of::<sys::Receiver>() as u32,
            flags: receiver.two_sided as u32,
            position: receiver.position.as_ptr(),
            normal: receiver.normal.as_ref().map_or(std::ptr::null(), |n| n.as_ptr()),
        };
        let result = unsafe {
            let (to, how, from) = (self.handle, &technique, &from);
            match light {
                Light::Sphere { center, radius } => {
                    sys::psc_build_sphere(to, how, from, center.as_ptr(), *radius)
                }
                Light::Cap { axis, half_angle } => {
                    sys::psc_build_cap(to, how, from, axis.as_ptr(), *half_angle)
                }
                Light::Disk { center, normal, radius } => {
                    sys::psc_build_disk(to, how, from, center.as_ptr(), normal.as_ptr(), *radius)
                }
                Light::Ellipse { center: c, axis_u: u, axis_v: v } => {
                    sys::psc_build_ellipse(to, how, from, c.as_ptr(), u.as_ptr(), v.as_ptr())
                }
                Light::Ellipsoid { center: c, axis_u: u, axis_v: v, axis_w: w } => {
                    let (c, u, v, w) = (c.as_ptr(), u.as_ptr(), v.as_ptr(), w.as_ptr());
                    sys::psc_build_ellipsoid(to, how, from, c, u, v, w)
                }
                Light::Triangle { v0, v1, v2 } => {
                    sys::psc_build_triangle(to, how, from, v0.as_ptr(), v1.as_ptr(), v2.as_ptr())
                }
                Light::Rectangle { corner: c, edge_u: u, edge_v: v } => {
                    sys::psc_build_rectangle(to, how, from, c.as_ptr(), u.as_ptr(), v.as_ptr())
                }
                Light::Polygon { vertices } => {
                    let first = vertices.as_ptr() as *const f64;
                    sys::psc_build_polygon(to, how, from, vertices.len(), first, VECTOR)
                }
            }
        };
        match result {
            0 => Ok(Some(Built { sampler: self })),
            EMPTY => Ok(None),
            error => Err(Error(error)),
        }
    }
}

impl Default for Sampler {
    fn default() -> Self {
        Sampler::new()
    }
}

impl Drop for Sampler {
    fn drop(&mut self) {
        unsafe { sys::psc_sampler_destroy(self.handle) }
    }
}

/// A light that can be seen, ready to be sampled.
#[derive(Clone, Copy)]
pub struct Built<'a> {
    sampler: &'a Sampler,
}

impl Built<'_> {
    /// Of weight 0 if the sample carries no light to the receiver.
    pub fn sample(&self, u: f64, v: f64) -> Sample {
        let mut out = Sample::default();
        unsafe { sys::psc_sample_f64(self.sampler.handle, u, v, &mut out) };
        out
    }

    pub fn pdf(&self, direction: &[f64; 3]) -> f64 {
        let mut out = 0.0;
        unsafe { sys::psc_pdf_f64(self.sampler.handle, direction.as_ptr(), &mut out) };
        out
    }

    /// None if the direction is not one that sample() can give.
    pub fn invert(&self, direction: &[f64; 3]) -> Option<[f64; 2]> {
        let mut uv = [0.0; 2];
        let result = unsafe {
            sys::psc_invert_f64(self.sampler.handle, direction.as_ptr(), uv.as_mut_ptr())
        };
        (result == 0).then(|| uv)
    }

    fn ask(&self, question: Question) -> Result<f64, Error> {
        let mut out = 0.0;
        match unsafe { question(self.sampler.handle, &mut out) } {
            error if error < 0 => Err(Error(error)),
            _ => Ok(out),
        }
    }

    /// In the measure that samples are uniform in.
    pub fn total(&self) -> f64 {
        self.ask(sys::psc_sampler_total).unwrap_or(f64::NAN)
    }

    /// Of the whole light, whether above the horizon or not.
    pub fn solid_angle(&self) -> f64 {
        self.ask(sys::psc_sampler_solid_angle).unwrap_or(f64::NAN)
    }

    pub fn projected_solid_angle(&self) -> Result<f64, Error> {
        self.ask(sys::psc_sampler_projected_solid_angle)
    }

    pub fn form_factor(&self) -> Result<f64, Error> {
        self.ask(sys::psc_sampler_form_factor)
    }

    pub fn area(&self) -> Result<f64, Error> {
        self.ask(sys::psc_sampler_area)
    }

    /// Fills as many samples as there are points. Panics if the lengths differ.
    pub fn sample_n(&self, uv: &[[f64; 2]], out: &mut [Sample]) {
        assert_eq!(uv.len(), out.len());
        if out.is_empty() {
            return;
        }
        let (input, samples) = (pairs(uv), fields(out, None));
        let result =
            unsafe { sys::psc_sample_n_f64(self.sampler.handle, uv.len(), &input, &samples) };
        debug_assert_eq!(result, 0);
    }
}

type Question = unsafe extern "C" fn(*const sys::Sampler, *mut f64) -> i32;

// ---- Arrays ----

const VECTOR: isize = std::mem::size_of::<Vector>() as isize;

fn pairs(uv: &[[f64; 2]]) -> sys::Input {
    let first = uv.as_ptr() as *const f64;
    sys::Input {
        component: [first, first.wrapping_add(1), std::ptr::null()],
        stride: std::mem::size_of::<[f64; 2]>() as isize,
    }
}

fn vectors(first: *const Vector, stride: isize) -> sys::Input {
    let first = first as *const f64;
    sys::Input { component: [first, first.wrapping_add(1), first.wrapping_add(2)], stride }
}

fn scalar(number: &f64) -> sys::Input {
    sys::Input { component: [number, std::ptr::null(), std::ptr::null()], stride: 0 }
}

// Where the library writes samples: numbers n of them from number k of each on.
fn fields(out: &mut [Sample], status: Option<&mut [i32]>) -> sys::Samples {
    let stride = std::mem::size_of::<Sample>() as isize;
    let base = out.as_mut_ptr() as *mut f64;
    let field = |k: usize, n: usize| {
        let mut component = [std::ptr::null_mut(); 3];
        for (i, pointer) in component.iter_mut().enumerate().take(n) {
            *pointer = base.wrapping_add(k + i);
        }
        sys::Output { component, stride }
    };
    sys::Samples {
        struct_size: std::mem::size_of::<sys::Samples>() as u32,
        reserved: 0,
        direction: field(0, 3),
        pdf: field(3, 1),
        point: field(4, 3),
        distance: field(7, 1),
        normal: field(8, 3),
        weight: field(11, 1),
        surface: field(12, 2),
        status: sys::OutputResult {
            data: status.map_or(std::ptr::null_mut(), |s| s.as_mut_ptr()),
            stride: std::mem::size_of::<i32>() as isize,
        },
    }
}

/// One build and one sample of a light for each position, with its normal unless they are in a
/// volume. Samples are left alone where status says that there is none. Panics if the lengths
/// differ.
pub fn sample_n(
    technique: &Technique,
    positions: &[Vector],
    normals: Option<&[Vector]>,
    light: &Light,
    uv: &[[f64; 2]],
    out: &mut [Sample],
    status: &mut [i32],
) -> Result<(), Error> {
    let count = positions.len();
    assert!(normals.map_or(true, |n| n.len() == count));
    assert!(uv.len() == count && out.len() == count && status.len() == count);
    let receivers = sys::Receivers {
        struct_size: std::mem::size_of::<sys::Receivers>() as u32,
        flags: 0,
        position: vectors(positions.as_ptr(), VECTOR),
        normal: vectors(normals.map_or(std::ptr::null(), |n| n.as_ptr()), VECTOR),
    };
    let (technique, uv, out) = (technique.borrow(), pairs(uv), fields(out, Some(status)));
    let fixed = |v: &Vector| vectors(v, 0);
    macro_rules! call {
        ($function:ident, $($part:expr),*) => {
            unsafe { sys::$function(&technique, count, &receivers, $(&$part,)* &uv, &out) }
        };
    }
    let result = match light {
        Light::Sphere { center, radius } => {
            call!(psc_sphere_sample_n_f64, fixed(center), scalar(radius))
        }
        Light::Cap { axis, half_angle } => {
            call!(psc_cap_sample_n_f64, fixed(axis), scalar(half_angle))
        }
        Light::Disk { center, normal, radius } => {
            call!(psc_disk_sample_n_f64, fixed(center), fixed(normal), scalar(radius))
        }
        Light::Ellipse { center, axis_u, axis_v } => {
            call!(psc_ellipse_sample_n_f64, fixed(center), fixed(axis_u), fixed(axis_v))
        }
        Light::Ellipsoid { center: c, axis_u: u, axis_v: v, axis_w: w } => {
            call!(psc_ellipsoid_sample_n_f64, fixed(c), fixed(u), fixed(v), fixed(w))
        }
        Light::Triangle { v0, v1, v2 } => {
            call!(psc_triangle_sample_n_f64, fixed(v0), fixed(v1), fixed(v2))
        }
        Light::Rectangle { corner, edge_u, edge_v } => {
            call!(psc_rectangle_sample_n_f64, fixed(corner), fixed(edge_u), fixed(edge_v))
        }
        Light::Polygon { vertices } => {
            let inputs: Vec<_> = vertices.iter().map(fixed).collect();
            unsafe {
                sys::psc_polygon_sample_n_f64(
                    &technique, count, &receivers, inputs.len(), inputs.as_ptr(), &uv, &out,
                )
            }
        }
    };
    if result < 0 { Err(Error(result)) } else { Ok(()) }
}
