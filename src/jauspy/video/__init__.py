"""H.264 video in RTP: encoding, packets, sending and receiving. Encoding and decoding need the extra `video`."""
