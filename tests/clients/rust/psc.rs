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
    pub struct Technique {
        pub struct_size: u32,
        pub measure: u32,
        pub map: u32,
        pub flags: u32,
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

    #[link(name = "psc")]
    extern "C" {
        pub fn psc_version() -> u32;
        pub fn psc_result_string(result: i32) -> *const c_char;
        pub fn psc_sampler_create(allocator: *const c_void, out: *mut *mut Sampler) -> i32;
        pub fn psc_sampler_destroy(sampler: *mut Sampler);
        pub fn psc_build_sphere(
            sampler: *mut Sampler,
            technique: *const Technique,
            receiver: *const Receiver,
            center: *const f64,
            radius: f64,
        ) -> i32;
        pub fn psc_build_cap(
            sampler: *mut Sampler,
            technique: *const Technique,
            receiver: *const Receiver,
            axis: *const f64,
            half_angle: f64,
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
        pub fn psc_sampler_total(sampler: *const Sampler, total: *mut f64) -> i32;
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
}

#[derive(Clone, Copy)]
pub struct Technique {
    pub measure: Measure,
    pub map: Map,
    pub one_sided: bool,
}

impl Technique {
    pub fn new(measure: Measure, map: Map) -> Self {
        Technique { measure, map, one_sided: false }
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

#[derive(Clone, Copy)]
pub enum Light {
    Sphere { center: [f64; 3], radius: f64 },
    Cap { axis: [f64; 3], half_angle: f64 },
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
    pub fn build(
        &mut self,
        technique: &Technique,
        receiver: &Receiver,
        light: &Light,
    ) -> Result<Option<Built<'_>>, Error> {
        let technique = sys::Technique {
            struct_size: std::mem::size_of::<sys::Technique>() as u32,
            measure: technique.measure as u32,
            map: technique.map as u32,
            flags: technique.one_sided as u32,
        };
        let from = sys::Receiver {
            struct_size: std::mem::size_of::<sys::Receiver>() as u32,
            flags: receiver.two_sided as u32,
            position: receiver.position.as_ptr(),
            normal: receiver.normal.as_ref().map_or(std::ptr::null(), |n| n.as_ptr()),
        };
        let result = unsafe {
            match light {
                Light::Sphere { center, radius } => {
                    sys::psc_build_sphere(self.handle, &technique, &from, center.as_ptr(), *radius)
                }
                Light::Cap { axis, half_angle } => {
                    sys::psc_build_cap(self.handle, &technique, &from, axis.as_ptr(), *half_angle)
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

    pub fn total(&self) -> f64 {
        let mut out = 0.0;
        unsafe { sys::psc_sampler_total(self.sampler.handle, &mut out) };
        out
    }

    /// Fills as many samples as there are points. Panics if the lengths differ.
    pub fn sample_n(&self, uv: &[[f64; 2]], out: &mut [Sample]) {
        assert_eq!(uv.len(), out.len());
        if out.is_empty() {
            return;
        }
        let stride = std::mem::size_of::<Sample>() as isize;
        let base = out.as_mut_ptr() as *mut f64;
        // The fields of a sample, n numbers from number k of it on.
        let field = |k: usize, n: usize| {
            let mut component = [std::ptr::null_mut(); 3];
            for (i, pointer) in component.iter_mut().enumerate().take(n) {
                *pointer = unsafe { base.add(k + i) };
            }
            sys::Output { component, stride }
        };
        let first = uv.as_ptr() as *const f64;
        let input = sys::Input {
            component: [first, unsafe { first.add(1) }, std::ptr::null()],
            stride: std::mem::size_of::<[f64; 2]>() as isize,
        };
        let samples = sys::Samples {
            struct_size: std::mem::size_of::<sys::Samples>() as u32,
            reserved: 0,
            direction: field(0, 3),
            pdf: field(3, 1),
            point: field(4, 3),
            distance: field(7, 1),
            normal: field(8, 3),
            weight: field(11, 1),
            surface: field(12, 2),
            status: sys::OutputResult { data: std::ptr::null_mut(), stride: 0 },
        };
        let result =
            unsafe { sys::psc_sample_n_f64(self.sampler.handle, uv.len(), &input, &samples) };
        debug_assert_eq!(result, 0);
    }
}
