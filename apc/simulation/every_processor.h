/// Marks a function whose body, everything it calls in sight included, is compiled once per instruction set; the
/// processor picks at load time by what it can do. Without products fused with sums (-ffp-contract=off) and with the
/// order of operations written out, all of them give the same bits.
#pragma once

#ifndef APC_FOR_EVERY_PROCESSOR
#define APC_FOR_EVERY_PROCESSOR __attribute__((flatten, target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
