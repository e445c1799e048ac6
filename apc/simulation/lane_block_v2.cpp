// Runs side by side for x86-64-v2: 2 doubles per vector.
#define APC_LANES 2
#include "apc/simulation/lane_block.inl"

LaneBlock* make_lane_block_v2() { return new Block; }

}  // namespace apc::simulation
