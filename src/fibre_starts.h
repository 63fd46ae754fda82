/* SPDX-License-Identifier: Apache-2.0 */
/* Written by fibre_starts.py: do not edit. */
#ifndef PSC_SRC_FIBRE_STARTS_H
#define PSC_SRC_FIBRE_STARTS_H

#define PSC_START_TERMS 8
#define PSC_MODEL_TERMS 6

/* Shares and their roots, cube roots first, then square roots. */
static const double psc_start_share[2 * PSC_START_TERMS] = {
    0x1.edb6f24d40dap-12, 0x1.90c46d95aba3ep-7, 0x1.ad0fc60729866p-5, 0x1.057133ecd4de9p-3,
    0x1.d8fe9529de552p-3, 0x1.5f3436b01dbe6p-2, 0x1.c0aadca56e9d9p-2, 0x1.f8a3a908e6753p-2,
    0x1.8323d546a15f6p-15, 0x1.d158af1cce256p-9, 0x1.948438bde105ap-6, 0x1.4bb6dfa31e658p-4,
    0x1.6da131b4dc631p-3, 0x1.35bbf726c49cep-2, 0x1.ad5913ef23b68p-2, 0x1.f635961e20001p-2};

static const double psc_start_root[2 * PSC_START_TERMS] = {
    0x1.3ea7496900d2fp-4, 0x1.d7db7bdf5688ep-3, 0x1.7f209c5fbb64fp-2, 0x1.01cd25ff9b863p-1,
    0x1.3a21c20f13967p-1, 0x1.6663f553db771p-1, 0x1.84e05603b4812p-1, 0x1.946af925e7246p-1,
    0x1.bd36d482da5b6p-8, 0x1.e81dbb7b2c599p-5, 0x1.41cd30c21846cp-3, 0x1.23688eecf1f5fp-2,
    0x1.b0ab3de2f583ap-2, 0x1.19969a376dab2p-1, 0x1.4b880ab040f73p-1, 0x1.668f78beee081p-1};

/* Places over their roots in powers of the tilt of a whole cone, from the top and the bottom; over
   the end too, in powers of its square, of a clipped one. */
static const double psc_start_model[2 * PSC_MODEL_TERMS * 2 * PSC_START_TERMS] = {
    0x1.adae316c2b416p+0, 0x1.b1933900bc3a5p+0, 0x1.b949083f553dfp+0, 0x1.c48ebcf8c652cp+0,
    0x1.d2bc322fa5b39p+0, 0x1.e2583ee6480a4p+0, 0x1.f097bcc22a1e2p+0, 0x1.f96f8824d0bc8p+0,
    0x1.ad15f5478ab08p+0, 0x1.b193807221388p+0, 0x1.b94c46c367e7fp+0, 0x1.c48e4e66f3eb6p+0,
    0x1.d2bbbb5d7b341p+0, 0x1.e25840d9e07e8p+0, 0x1.f097f1bbf1f22p+0, 0x1.f96fc420d29f9p+0,
    -0x1.1d5b035aa60ap-1, -0x1.19959a0a5411ap-1, -0x1.122ae311d2f1p-1, -0x1.0775d92edcd65p-1,
    -0x1.f485e94529c42p-2, -0x1.d83bd64965e48p-2, -0x1.bf29649b12619p-2, -0x1.aff661710ee5cp-2,
    0x1.7bff093266fdap-1, 0x1.19d0be3d3a3fcp-1, 0x1.103f6c046763fp-1, 0x1.07a185c8ab23dp-1,
    0x1.f4e39ca425c07p-2, 0x1.d83d03517cb46p-2, 0x1.bf1f83cecb30ep-2, 0x1.aff50dd91d8cdp-2,
    0x1.71c8e275836eep-2, 0x1.56662d3541c12p-2, 0x1.22f07cd65448cp-2, 0x1.bcaa14fd8c382p-3,
    0x1.265247d082924p-3, 0x1.3951f5ecde391p-4, 0x1.b8a98d3428a71p-6, 0x1.608cc81459d01p-10,
    -0x1.e19bb81be91dfp+0, 0x1.55d56bcff7222p-2, 0x1.559343fbc350ep-2, 0x1.b00e9548dc641p-3,
    0x1.175edfaae1dc7p-3, 0x1.39719ace263e9p-4, 0x1.ee1c49bae7fddp-6, 0x1.4bb69574ba04fp-8,
    -0x1.f0d05838169f2p-3, -0x1.aa3ccbef862e9p-3, -0x1.2c2b2c8ebbb5bp-3, -0x1.278b9328045fcp-4,
    -0x1.d5676ad5feaebp-9, 0x1.5c0cd8a92043dp-5, 0x1.f541308f9582p-5, 0x1.03ae1a96f528cp-4,
    0x1.36b6482f0bae6p+3, 0x1.2f36656886e65p-2, -0x1.f4d97709b5cfp-5, 0x1.5284844895186p-4,
    0x1.95421d47f5a2dp-6, -0x1.42bc2dc81d58ap-5, -0x1.fbc5da660d25p-5, -0x1.0437d9c8da087p-4,
    0x1.fcace25097f08p-4, 0x1.99e915884cf28p-4, 0x1.e12815b20edc5p-5, 0x1.a76b15b0cf409p-7,
    -0x1.69c855abdbc81p-6, -0x1.23744448112dp-5, -0x1.e922473160852p-6, -0x1.476e424874e09p-6,
    -0x1.fa3346c75ec84p+3, -0x1.1c70076884ff2p-4, 0x1.de9cfc589bf64p-2, -0x1.5d600a4f94fabp-6,
    -0x1.76a743b4fa052p-4, -0x1.3f0e2f48c2c96p-5, 0x1.a514ad2d4147ap-10, 0x1.13712baf4a5e5p-6,
    -0x1.02b700419637bp-5, -0x1.8fef87ffe4f78p-6, -0x1.9859b5132f2d4p-7, -0x1.b6817ba17ce58p-15,
    0x1.04ecf910b445cp-7, 0x1.2090ba2d4fc88p-7, 0x1.1c6cdc39403b9p-8, 0x1.58238adf08eb2p-16,
    0x1.3f54408b15873p+3, 0x1.bc8b6dd2c1f43p-2, -0x1.06ee760a533ffp-2, -0x1.51242fe8fa5e5p-5,
    0x1.99a5415749254p-6, 0x1.4377d61bdbb28p-6, 0x1.dada31236f298p-8, 0x1.538df9f5b60b6p-10,
    0x1.797e73f91e2ap-1, 0x1.7b78bb10eca0cp-1, 0x1.7f5bc9e4fa9e8p-1, 0x1.84f9abb976e62p-1,
    0x1.8bee5a947d68cp-1, 0x1.9373c1afca7d9p-1, 0x1.9a3145675f795p-1, 0x1.9e50c58ffea52p-1,
    0x1.36b8e099e3379p-2, 0x1.81cc1605e5889p-2, 0x1.8b884dfe6acc7p-2, 0x1.9c04daace84cfp-2,
    0x1.b508eb59f02cdp-2, 0x1.d288056537f9ep-2, 0x1.ef3c99bf5a99ep-2, 0x1.0111234557a54p-1,
    -0x1.665b4a2595d5fp-5, -0x1.5ee3b54ffdf19p-5, -0x1.506eae3356f25p-5, -0x1.3c1741cc9e8adp-5,
    -0x1.23de96d924bdp-5, -0x1.0af51d7be74aep-5, -0x1.eb920f37b2229p-6, -0x1.d2bafb969e1b6p-6,
    0x1.75581013fcc2fp-3, 0x1.0a62b9e0230bep-5, 0x1.3002cea9869dep-5, 0x1.4f6bba2803711p-5,
    0x1.3e5cd872187bcp-5, 0x1.264a28cb54e0bp-5, 0x1.11f4aabe2e73bp-5, 0x1.05bfb92a95cdp-5,
    0x1.58211feec7f5fp-10, 0x1.234eebb33c8cfp-10, 0x1.84c9f3674db1cp-11, 0x1.1ada8a7813b91p-12,
    -0x1.bc426f4ef343bp-13, -0x1.3e28f9e09f3e5p-11, -0x1.c041421ab07acp-11, -0x1.f7bb0c908a004p-11,
    -0x1.a82cb25999353p-4, 0x1.a4ce139dcf337p-7, 0x1.10331be8bdfb7p-7, 0x1.929f5d0bc942ap-9,
    0x1.129d9153469f7p-9, 0x1.cb536183c061ap-10, 0x1.697b13df5c9b2p-10, 0x1.2745a4f4096bcp-10,
    -0x1.687e796b3d314p-18, 0x1.ab36393c9b4e3p-17, 0x1.6506542bf486bp-15, 0x1.2fc4f4741f6f4p-14,
    0x1.73bc652390fcfp-14, 0x1.59c2ade7d7771p-14, 0x1.ed5f70b82f66ap-15, 0x1.3a1ff3717c876p-15,
    0x1.414857cd01818p-5, -0x1.f564fe11fd326p-10, -0x1.0be2c85fbf961p-10, 0x1.ce0ea97b70cbep-12,
    0x1.9f33d25c0dfd7p-12, 0x1.35c9c324372fdp-13, 0x1.879800d79e696p-17, -0x1.1c84b6d2dfb4p-15,
    -0x1.ea3a3066182f9p-26, -0x1.d028c1e037aa8p-21, -0x1.08fdc50006657p-19, -0x1.3ffc8f005abe7p-19,
    -0x1.2957f5cdccaccp-20, 0x1.1fa62c9f03fb7p-19, 0x1.a5c07d2a27edep-18, 0x1.340e6d20531c2p-17,
    -0x1.99e9b42998569p-8, 0x1.982f8ba286e94p-12, 0x1.353f90e9b6a06p-12, -0x1.4bb30671b57c6p-18,
    -0x1.b0c5e97f44b91p-15, -0x1.2308130755b26p-15, -0x1.3849b8953b54fp-16, -0x1.83d645be25824p-17,
    -0x1.64b3c75dc07d9p-25, -0x1.ae246cc909febp-26, -0x1.89d188c1167a5p-27, -0x1.1ab3b1fe47a6cp-25,
    -0x1.fa35133c1c921p-24, -0x1.1cccbad9a16a6p-22, -0x1.c9daf56dd312fp-22, -0x1.1c00014e52d46p-21,
    0x1.adc2c7f50974p-12, -0x1.776c2a2499039p-18, -0x1.2623cadb0ba17p-16, -0x1.47919e7ac736dp-19,
    0x1.73c9213d5e9f9p-20, 0x1.70844797e7fep-20, 0x1.e105afcd20358p-21, 0x1.5794e1703d7a8p-21};

/* [j][k]: what the value at a node adds to a coefficient; for either root. */
static const double psc_start_powers[2 * PSC_START_TERMS * PSC_START_TERMS] = {
    0x1.44e6c595afdccp+0, -0x1.81695eab7616fp+5, 0x1.3e231ba8d883bp+9, -0x1.f899fd81cd61ap+11,
    0x1.af1df787921c1p+13, -0x1.9698a0b355aedp+14, 0x1.8e95d89b24676p+14, -0x1.3d1e7abd9fcdp+13,
    -0x1.a5f59e90600ddp-2, 0x1.2fdbe09304c86p+6, -0x1.540349e07d208p+10, 0x1.32fdd88cb280cp+13,
    -0x1.19167886396a9p+15, 0x1.14686373742f4p+16, -0x1.1675a8f6bc484p+16, 0x1.c38a12263a931p+14,
    0x1.def13b73c1406p-3, -0x1.6ec5ab115665dp+5, 0x1.3a1fbe27cad96p+10, -0x1.5c1df9f6ccb51p+13,
    0x1.6657cb3f43f66p+15, -0x1.7b832ef41460cp+16, 0x1.9210020dff643p+16, -0x1.51e3605644501p+15,
    -0x1.37efd8d87607ep-3, 0x1.e58e8339d3bd7p+4, -0x1.c7fbe5ba53a01p+9, 0x1.290239eda7ef9p+13,
    -0x1.596e623651f6ep+15, 0x1.8f8d5d17a48cep+16, -0x1.c3a33eb2de665p+16, 0x1.8e90f8a4746bap+15,
    0x1.a43002ae4285p-4, -0x1.49248ae6d0093p+4, 0x1.4018af78f10fdp+9, -0x1.bd33dfb308793p+12,
    0x1.1a11b230bfb36p+15, -0x1.614405d84a52ep+16, 0x1.ab255c0c2fbcfp+16, -0x1.8e90f8a4746bap+15,
    -0x1.11ab7190834ecp-4, 0x1.ae0f5b188e5b3p+3, -0x1.a91fc8b15a926p+8, 0x1.30f6acff54ec1p+12,
    -0x1.9465ae67f077ep+14, 0x1.0bc45818635fdp+16, -0x1.56ef2a6f9a49ap+16, 0x1.51e3605644501p+15,
    0x1.36a08355c63dcp-5, -0x1.e8e204f2caae2p+2, 0x1.e72f169620465p+7, -0x1.62ea5abc4417dp+11,
    0x1.e1d07727eee9ep+13, -0x1.4953192f865cap+15, 0x1.b6a9a2b0ae5b6p+15, -0x1.c38a12263a931p+14,
    -0x1.936bb8c5b2da2p-7, 0x1.3dab64576d0d6p+1, -0x1.3da57a17616d1p+6, 0x1.d1d96e5d069a9p+9,
    -0x1.3f6b395b026e8p+12, 0x1.bae6876bd98d9p+13, -0x1.2c9e4e0069c1dp+14, 0x1.3d1e7abd9fcdp+13,
    0x1.44e6c595afdccp+0, -0x1.575cd9facae41p+5, 0x1.f902e01952bfep+8, -0x1.64cea2055b112p+11,
    0x1.0f9633d3ecb7cp+13, -0x1.c86388c78a59fp+13, 0x1.8e95d89b24676p+13, -0x1.1a855dec071b5p+12,
    -0x1.a5f59e90600ddp-2, 0x1.0eb51ec0607aep+6, -0x1.0dde4dce6660bp+10, 0x1.b226d3704a564p+12,
    -0x1.6225fdf8be49cp+14, 0x1.3641d9c07518dp+15, -0x1.1675a8f6bc484p+15, 0x1.92469c0dcf32dp+13,
    0x1.def13b73c1406p-3, -0x1.46c1bfa8df5eep+5, 0x1.f2a408e290421p+9, -0x1.ec4fd9d51139bp+12,
    0x1.c37bdb9933348p+14, -0x1.a9fd0194c5edcp+15, 0x1.9210020dff643p+15, -0x1.2d062ef88e319p+14,
    -0x1.37efd8d87607ep-3, 0x1.b094f2fab49d1p+4, -0x1.69ea2b18ab178p+9, 0x1.a408a24eb38c9p+12,
    -0x1.b3374d42c445ap+14, 0x1.c07b705442206p+15, -0x1.c3a33eb2de665p+15, 0x1.63150b15e8536p+14,
    0x1.a43002ae4285p-4, -0x1.253b9c0036deap+4, 0x1.fc1f147251477p+8, -0x1.3ace48ebb5008p+12,
    0x1.6362841d06b17p+14, -0x1.8c8700e0b076ap+15, 0x1.ab255c0c2fbcfp+15, -0x1.63150b15e8536p+14,
    -0x1.11ab7190834ecp-4, 0x1.7f23cfb78697p+3, -0x1.516bd81b8387ep+8, 0x1.af489bc69817ep+11,
    -0x1.fd822f5edbc4cp+13, 0x1.2c8eea2d2847dp+15, -0x1.56ef2a6f9a49ap+15, 0x1.2d062ef88e319p+14,
    0x1.36a08355c63dcp-5, -0x1.b38b8e2e19e53p+2, 0x1.82ad9b1e0860fp+7, -0x1.f5ed1dfa14a1fp+10,
    0x1.2f8624eab2515p+13, -0x1.71a784b1aee5ep+14, 0x1.b6a9a2b0ae5b6p+14, -0x1.92469c0dcf32dp+13,
    -0x1.936bb8c5b2da2p-7, 0x1.1b02e7d8c04d6p+1, -0x1.f83b72caac13p+5, 0x1.4967bcfd77e3ep+9,
    -0x1.92714954c7c5ep+11, 0x1.f12395f28765fp+12, -0x1.2c9e4e0069c1dp+13, 0x1.1a855dec071b5p+12};

#endif
