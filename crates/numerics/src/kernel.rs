//! Code that is compiled once for each set of vector instructions, and run with the best that the machine has.

/// Code that is compiled once for each set of vector instructions: mark its functions `#[inline(always)]`.
///
/// ```
/// use lanchester_numerics::{Kernel, dispatch};
/// struct Sum<'a>(&'a [f64; 8], &'a mut f64);
/// impl Kernel for Sum<'_> {
///     #[inline(always)]
///     fn run<const FMA: bool>(self) {
///         *self.1 = self.0.iter().sum();
///     }
/// }
/// let mut sum = 0.0;
/// dispatch(Sum(&[1.0; 8], &mut sum));
/// assert_eq!(sum, 8.0);
/// ```
pub trait Kernel {
    /// Runs it; `FMA`: fused multiply-add is one instruction.
    fn run<const FMA: bool>(self);
}

/// Sets of vector instructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Vectors {
    /// What the program was compiled for.
    Portable,
    /// AVX2 with fused multiply-add.
    Avx2,
    /// AVX-512.
    Avx512,
}

impl Vectors {
    /// All that this machine has, the best last.
    pub fn available() -> impl Iterator<Item = Vectors> {
        [Vectors::Portable, Vectors::Avx2, Vectors::Avx512].into_iter().filter(|own| own.is_available())
    }

    #[cfg(target_arch = "x86_64")]
    fn is_available(self) -> bool {
        match self {
            Vectors::Portable => true,
            Vectors::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            Vectors::Avx512 => {
                Vectors::Avx2.is_available()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512vl")
                    && is_x86_feature_detected!("avx512dq")
            }
        }
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn is_available(self) -> bool {
        self == Vectors::Portable
    }

    /// Runs `kernel` with these, or with those that the program was compiled for where the machine lacks them.
    #[allow(unsafe_code)]
    pub fn run<K: Kernel>(self, kernel: K) {
        #[cfg(target_arch = "x86_64")]
        if self.is_available() {
            match self {
                // SAFETY: the function is safe but for its instructions, and the machine was just found to have them.
                Vectors::Avx512 => return unsafe { run_avx512(kernel) },
                // SAFETY: as above.
                Vectors::Avx2 => return unsafe { run_avx2(kernel) },
                Vectors::Portable => {}
            }
        }
        // Elsewhere a fused multiply-add may be a library call; on 64-bit ARM it is always there.
        if cfg!(target_arch = "aarch64") {
            kernel.run::<true>();
        } else {
            kernel.run::<false>();
        }
    }
}

/// Runs `kernel` with the best vector instructions that this machine has.
pub fn dispatch<K: Kernel>(kernel: K) {
    let best = [Vectors::Avx512, Vectors::Avx2].into_iter().find(|own| own.is_available());
    best.unwrap_or(Vectors::Portable).run(kernel);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn run_avx512<K: Kernel>(kernel: K) {
    kernel.run::<true>();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_avx2<K: Kernel>(kernel: K) {
    kernel.run::<true>();
}
