// Runs side by side for x86-64-v4: 8 doubles per vector.
#define APC_LANES 8
#include "apc/simulation/lane_block.inl"

LaneBlock* make_lane_block_v4() { return new Block; }

}  // namespace apc::simulation
