/* SPDX-License-Identifier: Apache-2.0 */
/* Written by coefficients.py: do not edit. */
#ifndef PSC_SRC_COEFFICIENTS_H
#define PSC_SRC_COEFFICIENTS_H

/* (x - sin x) / x^3 of x^2 in [0, pi^2/4]: relative error 6.3e-17 */
#define PSC_SINE_F64 \
    0x1.5555555555555p-3, -0x1.1111111111107p-7, 0x1.a01a01a018aadp-13, \
    -0x1.71de3a5456716p-19, 0x1.ae6455a1d7087p-26, -0x1.6124015b5ee3ap-33, \
    0x1.ae5138c1216b3p-41, -0x1.89a4866f527ebp-49

/* (x - sin x) / x^3 of x^2 in [0, pi^2/4]: relative error 3.3e-8 */
#define PSC_SINE_F32 \
    0x1.555556p-3f, -0x1.11111p-7f, 0x1.a01906p-13f, \
    -0x1.719692p-19f, 0x1.9db1ccp-26f

/* (1 - cos x) / x^2 of x^2 in [0, pi^2/4]: relative error 1.1e-17 */
#define PSC_COSINE_F64 \
    0x1p-1, -0x1.5555555555555p-5, 0x1.6c16c16c16bf5p-10, \
    -0x1.a01a01a017cc2p-16, 0x1.27e4fb7663246p-22, -0x1.1eed8e52d29a7p-29, \
    0x1.9396d39886b4ep-37, -0x1.ae4f74e861e2cp-45, 0x1.5dc6f502ce37ep-53

/* (1 - cos x) / x^2 of x^2 in [0, pi^2/4]: relative error 5.9e-9 */
#define PSC_COSINE_F32 \
    0x1p-1f, -0x1.555552p-5f, 0x1.6c152ap-10f, \
    -0x1.9fa602p-16f, 0x1.1a5e1p-22f

/* (t - atan t) / t^3 of t^2 in [0, 1]: relative error 1.6e-16 */
#define PSC_ATAN_F64 \
    0x1.5555555555555p-2, -0x1.99999999998f9p-3, 0x1.249249248c7dap-3, \
    -0x1.c71c71c472843p-4, 0x1.745d16f26d0a3p-4, -0x1.3b13aaf4aba4ap-4, \
    0x1.1110bfea8ed5ep-4, -0x1.e1dc0d7679adcp-5, 0x1.af00bd568a3d2p-5, \
    -0x1.854a7b99af61dp-5, 0x1.60ebd1489b946p-5, -0x1.3d3f26d5ea7ffp-5, \
    0x1.147b2825d82f6p-5, -0x1.c3ac54a572735p-6, 0x1.4b974a27ac39fp-6, \
    -0x1.a1fe88baf72d4p-7, 0x1.aef1a8e977bf8p-8, -0x1.57cc888719aa0p-9, \
    0x1.8a2f3ae537bb1p-11, -0x1.1f0adb240a1fbp-13, 0x1.8d087295ab9f4p-17

/* (t - atan t) / t^3 of t^2 in [0, 0.18]: relative error 2.2e-16 */
#define PSC_ATAN_NEAR_F64 \
    0x1.5555555555554p-2, -0x1.9999999998fccp-3, 0x1.2492492409ac8p-3, \
    -0x1.c71c716a0319fp-4, 0x1.745d06f200126p-4, -0x1.3b1203918f4bcp-4, \
    0x1.10f55833e4fe7p-4, -0x1.df8f741d6f6c5p-5, 0x1.9ede38ddc7328p-5, \
    -0x1.3c809b716f6d0p-5, 0x1.2e84aac3c544fp-6

/* (t - atan t) / t^3 of t^2 in [0, 1]: relative error 9.3e-8 */
#define PSC_ATAN_F32 \
    0x1.555554p-2f, -0x1.99983cp-3f, 0x1.246cd2p-3f, \
    -0x1.c3f168p-4f, 0x1.6295f8p-4f, -0x1.0001c6p-4f, \
    0x1.25dc12p-5f, -0x1.ba9f66p-7f, 0x1.38de56p-9f

/* (N - 1) / w, N = 3/2 (x - sin x cos x) / sin^3 x, of w as in segment.h: relative error 1.1e-16 */
#define PSC_SEGMENT_F64 \
    0x1.3333333333333p+0, 0x1.5643a55141cccp-1, 0x1.50bf9a865abd1p-2, \
    0x1.3d87df4eb20e3p-3, 0x1.230d4e32db078p-4, 0x1.066d684ec32eap-5, \
    0x1.d321e21ef9401p-7, 0x1.9cd4c63efb885p-8, 0x1.6378b4092faecp-9, \
    0x1.6125a9fff1989p-10, 0x1.3ef555b420657p-13, 0x1.d31385628a3d9p-11, \
    -0x1.8d93d2f4e818dp-11, 0x1.9cf333ccfe0cdp-11, -0x1.964cd0a0fe297p-12, \
    0x1.eba3cc819b3afp-14

/* (N - 1) / w, N = 3/2 (x - sin x cos x) / sin^3 x, of w as in segment.h: relative error 6.0e-8 */
#define PSC_SEGMENT_F32 \
    0x1.333332p+0f, 0x1.564426p-1f, 0x1.50a20ep-2f, \
    0x1.4014d2p-3f, 0x1.07cefep-4f, 0x1.a08c28p-5f, \
    -0x1.c5ed8p-7f, 0x1.a4863p-6f

#endif
