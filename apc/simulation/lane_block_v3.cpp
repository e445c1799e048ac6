// Runs side by side for x86-64-v3: 4 doubles per vector.
#define APC_LANES 4
#include "apc/simulation/lane_block.inl"

LaneBlock* make_lane_block_v3() { return new Block; }

}  // namespace apc::simulation
