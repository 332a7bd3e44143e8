-- Large messages -----------------------------------------------------------------------------------------------------

local routes = {}               -- by source and destination: the message that is being put together
local finished = {}             -- by frame and offset: the large message to which the fragment there belongs
local pending_bytes = 0

function jaus.init()
    routes, finished, pending_bytes = {}, {}, 0
end

-- Moves the fragments that follow one another from those that wait into the message.
local function advance(route)
    while route.message do
        local fragment = route.waiting[route.next]
        if not fragment then return end
        route.waiting[route.next] = nil
        route.waiting_count = route.waiting_count - 1
        route.next = (route.next + 1) % 65536
        local message = route.message
        message[#message + 1] = fragment
        finished[fragment.key] = message
        if fragment.flag == 3 then
            local bytes = ByteArray.new()
            for i = 1, #message do
                bytes:append(message[i].bytes)
                pending_bytes = pending_bytes - message[i].bytes:len() - FRAGMENT_COST
                message[i].bytes = nil
            end
            message.bytes, message.frame, message.last_key = bytes, route.frame, route.key
            route.message = nil
        end
    end
end

-- Notes a fragment when it is seen for the first time.
local function collect(pinfo, key, source, destination, sequence, flag, range)
    local name = source .. ">" .. destination
    local route = routes[name]
    if not route then
        route = { waiting = {}, waiting_count = 0 }
        routes[name] = route
    end
    if flag == 1 then
        route.message, route.next = {}, sequence
    elseif route.message and (sequence - route.next) % 65536 >= 32768 then
        return  -- sent again
    end
    if route.waiting_count >= MAX_GAP then route.waiting, route.waiting_count = {}, 0 end
    if pending_bytes + range:len() > MAX_PENDING then
        routes, pending_bytes = {}, 0
        return
    end
    if not route.waiting[sequence] then route.waiting_count = route.waiting_count + 1 end
    route.waiting[sequence] = { key = key, flag = flag, bytes = range:bytes() }
    pending_bytes = pending_bytes + range:len() + FRAGMENT_COST
    route.frame, route.key = pinfo.number, key
    advance(route)
end

local function read_fragment(tvb, pinfo, tree, budget, packet)
    local range = tvb(packet.payload, packet.stop - 2 - packet.payload)
    local key = pinfo.number .. ":" .. packet.label .. ":" .. packet.start
    if not pinfo.visited then
        collect(pinfo, key, packet.source, packet.destination, packet.sequence, packet.flag, range)
    end
    local item = tree:add(F.fragment, range)
    local message = finished[key]
    local name = DATA_FLAGS[packet.flag] .. " fragment"
    if not message or not message.bytes then return name end
    if message.last_key ~= key then
        item:add(F.reassembled_in, message.frame):set_generated()
        return name
    end
    item:add(F.fragments, #message):set_generated()
    local whole = message.bytes:tvb("JAUS message")
    return read_message(reader_of(whole, 0, whole:len(), budget, 0), tree) or name
end

-- Packets ------------------------------------------------------------------------------------------------------------

local function id_of(range)
    return string.format("%d.%d.%d", range(2, 2):le_uint(), range(1, 1):uint(), range(0, 1):uint())
end

-- Why the bytes at `start` are no header, or nil; and the offset of the control byte and the size.
local function header_at(tvb, start, stop)
    local left = stop - start
    if left < 14 then return string.format("%s are too few for a header", plural(left, "byte")) end
    local flags, size = tvb(start, 1):uint(), tvb(start + 1, 2):le_uint()
    local compression, minimum = math.floor(flags / 64), 14
    if compression > 1 then return "header compression, which is not decoded" end
    if compression == 1 then minimum = 16 end
    if size < minimum then return string.format("a data size of %d is below the minimum of %d", size, minimum) end
    if size > left then return string.format("a data size of %d in %s", size, plural(left, "byte")) end
    if flags % 64 ~= 0 then return string.format("message type %d is reserved", flags % 64) end
    return nil, start + (compression == 1 and 5 or 3), size
end

local function read_packet(tvb, pinfo, root, budget, start, control, size, label)
    local stop = start + size
    local byte = tvb(control, 1):uint()
    local packet = {
        start = start, stop = stop, payload = control + 9, label = label,
        destination = id_of(tvb(control + 1, 4)), source = id_of(tvb(control + 5, 4)),
        sequence = tvb(stop - 2, 2):le_uint(), flag = math.floor(byte / 64),
    }
    local ack, broadcast = math.floor(byte / 16) % 4, math.floor(byte / 4) % 4
    budget.left = budget.left - 16
    local tree = root:add(tvb(start, size), string.format("%s → %s", packet.source, packet.destination))
    local head = tree:add(tvb(start, control + 9 - start), "Header")
    head:add(F.message_type, tvb(start, 1))
    head:add(F.compression, tvb(start, 1))
    head:add_le(F.size, tvb(start + 1, 2))
    if control > start + 3 then
        head:add(F.hc_number, tvb(start + 3, 1))
        head:add(F.hc_length, tvb(start + 4, 1))
    end
    for _, field in ipairs({ F.priority, F.broadcast, F.ack, F.data_flag }) do head:add(field, tvb(control, 1)) end
    head:add(F.destination, tvb(control + 1, 4), packet.destination)
    head:add(F.source, tvb(control + 5, 4), packet.source)
    head:add_le(F.sequence, tvb(stop - 2, 2))
    local first, last = packet.payload, stop - 2
    local faulty = broadcast == 3 and ack == 3 and packet.flag == 3
    local name
    if first == last then
        name = ACKS[ack] ~= "none" and ACKS[ack] or "no message"
    elseif (packet.flag == 0 and ack ~= 3) or faulty then
        if faulty then
            spend(budget)
            head:add_proto_expert_info(X.value, "control byte FF, as a faulty sender of priority 0 sets it; taken for a single packet")
        end
        name = read_message(reader_of(tvb, first, last, budget, 0), tree)
    elseif ack == 3 then
        tree:add(F.data, tvb(first, last - first)):append_text(" (an acknowledgement with a payload)")
        name = "ACK"
    else
        name = read_fragment(tvb, pinfo, tree, budget, packet)
    end
    tree:append_text(", " .. (name or "message"))
    return string.format("%s → %s %s", packet.source, packet.destination, name or "malformed message")
end

local function note(pinfo, info, text)
    info[#info + 1] = text
    if #info <= 8 then pinfo.cols.info:set(table.concat(info, "; ") .. (#info == 8 and "; ..." or "")) end
end

-- The packets from `start` on; stops at the first that is not readable.
local function read_packets(tvb, pinfo, root, budget, start, label, info)
    while start < tvb:len() do
        local problem, control, size = header_at(tvb, start, tvb:len())
        if problem then
            spend(budget)
            root:add(F.data, tvb(start)):add_proto_expert_info(X.header, problem)
            note(pinfo, info, "malformed header")
            return
        end
        note(pinfo, info, read_packet(tvb, pinfo, root, budget, start, control, size, label))
        start = start + size
    end
end

local function read_datagram(tvb, pinfo, root, budget, label, info)
    local version = tvb(0, 1):uint()
    spend(budget)
    local item = root:add(F.version, tvb(0, 1))
    if version == 2 then
        read_packets(tvb, pinfo, root, budget, 1, label, info)
    elseif (version == 1 and tvb:len() >= 21) or (tvb:len() >= 8 and tvb(0, 8):string() == "JAUS01.0") then
        item:add_proto_expert_info(X.old, "a header of AS5669 version 1 or OPC, which is not decoded")
        note(pinfo, info, "header older than AS5669A")
    else
        item:add_proto_expert_info(X.header, string.format("version %d is unknown", version))
        note(pinfo, info, string.format("version %d", version))
    end
end

-- Runs `work` so that no error leaves this file.
local function guarded(pinfo, root, work)
    local budget = { left = MAX_ITEMS }
    local ok, reason = pcall(work, budget)
    if ok then return end
    if reason == TOO_MANY then
        root:add_proto_expert_info(X.limit, string.format("more than %d items; the rest is not shown", MAX_ITEMS))
    else
        root:add_proto_expert_info(X.failed, tostring(reason):sub(1, 200))
    end
end

-- UDP and TCP --------------------------------------------------------------------------------------------------------

local function dissect_judp(tvb, pinfo, tree)
    pinfo.cols.protocol:set("JAUS")
    local root = tree:add(jaus, tvb())
    guarded(pinfo, root, function(budget) read_datagram(tvb, pinfo, root, budget, "udp", {}) end)
    return tvb:len()
end

-- A stream begins with the version; after it no packet can begin with 02, a reserved message type. So the bytes that
-- Wireshark hands over tell by themselves whether the version is among them.
local function dissect_jtcp(tvb, pinfo, tree)
    pinfo.cols.protocol:set("JAUS")
    local root = tree:add(jaus, tvb())
    guarded(pinfo, root, function(budget)
        local start, info = 0, {}
        if tvb(0, 1):uint() == 2 then
            root:add(F.version, tvb(0, 1))
            start = 1
            if tvb:len() == 1 then pinfo.cols.info:set("JTCP version 2") end
        end
        while start < tvb:len() do
            local left = tvb:len() - start
            local size = left >= 3 and tvb(start + 1, 2):le_uint() or 0
            local flags = tvb(start, 1):uint()
            local plausible = (flags == 0 or flags == 64) and (left < 3 or size >= 14)
            if plausible and (left < 3 or size > left) and pinfo.can_desegment > 0 then
                pinfo.desegment_offset = start
                pinfo.desegment_len = left < 3 and DESEGMENT_ONE_MORE_SEGMENT or size - left
                return
            end
            local problem, control = header_at(tvb, start, tvb:len())
            if problem then
                spend(budget)
                root:add(F.data, tvb(start)):add_proto_expert_info(X.header, "the stream has no packet here: " .. problem)
                note(pinfo, info, "malformed header")
                return
            end
            note(pinfo, info, read_packet(tvb, pinfo, root, budget, start, control, size, "tcp"))
            start = start + size
        end
    end)
    return tvb:len()
end

-- One entry for both: Wireshark says over what the bytes came.
function jaus.dissector(tvb, pinfo, tree)
    if tvb:len() == 0 then return 0 end
    if pinfo.port_type == 2 then return dissect_jtcp(tvb, pinfo, tree) end
    return dissect_judp(tvb, pinfo, tree)
end

DissectorTable.get("udp.port"):add(3794, jaus)
DissectorTable.get("tcp.port"):add(3794, jaus)
