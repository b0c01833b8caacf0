# Two machines and what is lost between them, for the tests of this folder; sourced after session.sh.

# lose PERCENT: throws away that share of the frames that arrive at this pretend machine, and counts by channel what it
# throws away. Every message of Scanway is one frame; its channel's name begins 8 bytes behind the UDP header.
lose() {
  nft -f - <<NFT
table netdev loss {
  counter COST_MAP {}
  counter CLOUD_TILE {}
  counter OCTOMAP {}
  counter PIECE_REQUEST {}
  counter fragments {}
  counter every_frame {}
  chain in {
    type filter hook ingress device "eth0" priority 0; policy accept;
    ether type ip numgen random mod 100000 < $(($1 * 1000)) jump lost
  }
  chain lost {
    counter name every_frame
    @th,128,64 0x434f53545f4d4150 counter name COST_MAP
    @th,128,64 0x434c4f55445f5449 counter name CLOUD_TILE
    @th,128,56 0x4f43544f4d4150 counter name OCTOMAP
    @th,128,64 0x50494543455f5245 counter name PIECE_REQUEST
    ip frag-off & 0x3fff != 0 counter name fragments
    drop
  }
}
NFT
}

# lost_at MACHINE: lines "MACHINE LOST CHANNEL NUMBER" of what lose has thrown away there.
lost_at() {
  ip netns exec "$1" nft -j list counters | python3 -c '
import json, sys
for item in json.load(sys.stdin)["nftables"]:
    if "counter" in item: print(sys.argv[1], "LOST", item["counter"]["name"], item["counter"]["packets"])' "$1"
}
