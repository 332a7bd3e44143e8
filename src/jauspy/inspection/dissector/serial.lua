-- Serial lines -------------------------------------------------------------------------------------------------------

local bxor = (bit32 or bit).bxor

-- CRC-16 with the polynomial 8408h, reflected, without final XOR.
local function crc16(bytes, first, last, crc)
    for i = first, last do
        crc = bxor(crc, bytes[i])
        for _ = 1, 8 do
            local odd = crc % 2
            crc = math.floor(crc / 2)
            if odd == 1 then crc = bxor(crc, 0x8408) end
        end
    end
    return crc
end

local function number_at(bytes, at)
    return (bytes[at] or 0) + 256 * (bytes[at + 1] or 0)
end

-- The frames of a record: `parts` are the bytes between the marks, with doubled DLE made single.
local function serial_frames(tvb)
    local frames, frame, at, size = {}, nil, 0, tvb:len()
    local marks = { 2, 3 }
    local raw = tvb():bytes()
    while at < size do
        local byte, mark = raw:get_index(at), nil
        if byte == 16 and at + 1 < size then
            at = at + 1
            if raw:get_index(at) ~= 16 then mark = raw:get_index(at) end
        end
        at = at + 1
        if mark == 1 then
            frame = { start = at - 2, stop = at, {} }
            frames[#frames + 1] = frame
        elseif frame and mark and mark == marks[#frame] then
            frame[#frame + 1] = {}
        elseif frame and mark then
            frame = nil
        elseif frame then
            local part = frame[#frame]
            part[#part + 1] = byte
            frame.stop = at
            if #frame == 3 and #part == 2 then frame = nil end
        end
    end
    return frames
end

local function read_frame(tvb, pinfo, root, budget, frame, number, info)
    spend(budget)
    local item = root:add(tvb(frame.start, frame.stop - frame.start), string.format("JSerial frame %d", number))
    local head, body, tail = frame[1], frame[2], frame[3]
    if not tail or #tail < 2 or #head < 3 or #body < 2 then
        item:add_proto_expert_info(X.truncated, "the frame is not complete in this record")
        return
    end
    local header_crc = number_at(body, 1)
    if crc16(head, 1, #head, 0xFFFF) ~= header_crc and crc16(head, 1, 3, 0xFFFF) ~= header_crc then
        item:add_proto_expert_info(X.checksum, "the checksum of the header is wrong")
    end
    if crc16(body, 1, #body, header_crc) ~= number_at(tail, 1) then
        item:add_proto_expert_info(X.checksum, "the checksum of the packet is wrong")
    end
    if #body - 2 ~= number_at(head, 2) then
        item:add_proto_expert_info(X.header, string.format("%d bytes where %d were announced", #body - 2, number_at(head, 2)))
    end
    local datagram = ByteArray.new()
    datagram:set_size(#body - 1)
    datagram:set_index(0, head[1] % 16)
    for i = 3, #body do datagram:set_index(i - 2, body[i]) end
    read_datagram(datagram:tvb("JSerial packet"), pinfo, item, budget, "serial" .. number, info)
end

function jserial.dissector(tvb, pinfo, tree)
    if tvb:len() == 0 then return 0 end
    pinfo.cols.protocol:set("JSerial")
    local root = tree:add(jserial, tvb())
    guarded(pinfo, root, function(budget)
        local info, frames = {}, serial_frames(tvb)
        for number, frame in ipairs(frames) do read_frame(tvb, pinfo, root, budget, frame, number, info) end
        if #frames == 0 then root:add(F.data, tvb()):add_proto_expert_info(X.header, "no frame begins here") end
    end)
    return tvb:len()
end

DissectorTable.get("udp.port"):add_for_decode_as(jserial)
DissectorTable.get("tcp.port"):add_for_decode_as(jserial)
