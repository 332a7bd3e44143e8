-- The engine reads packets, and the fields of messages along the tables above. `MESSAGES` has the definitions by
-- message id, `AMBIGUOUS` the ids with several meanings, `ENUMS` the named values.
--
-- Nothing here may raise an error, whatever a packet contains: every read is preceded by a check of the length, the
-- number of tree items of a frame is bounded, and each frame is dissected under pcall.

local MAX_ITEMS = 100000        -- tree items of one frame; Wireshark itself gives up at 1,000,000
local MAX_NESTING = 8           -- messages inside messages
local MAX_PENDING = 64 * 2^20   -- bytes of fragments that wait for others, all together
local FRAGMENT_COST = 256       -- bytes that a fragment takes besides its own
local MAX_GAP = 1024            -- fragments of one sender that wait for an earlier one

local SIZES = { B = 1, H = 2, I = 4, Q = 8, b = 1, h = 2, i = 4, q = 8, f = 4, d = 8 }
local PRIORITIES = { [0] = "low", "standard", "high", "safety critical" }
local BROADCASTS = { [0] = "none", "local", "global", "reserved" }
local ACKS = { [0] = "none", "required", "NAK", "ACK" }
local DATA_FLAGS = { [0] = "single", "first", "middle", "last" }

local jaus = Proto("jaus", "Joint Architecture for Unmanned Systems")
local jserial = Proto("jserial", "JAUS on a serial line")

local F = {
    version = ProtoField.uint8("jaus.header.version", "Version"),
    message_type = ProtoField.uint8("jaus.header.message_type", "Message type", base.DEC, nil, 0x3F),
    compression = ProtoField.uint8("jaus.header.compression", "Header compression", base.DEC, nil, 0xC0),
    size = ProtoField.uint16("jaus.header.data_size", "Data size"),
    hc_number = ProtoField.uint8("jaus.header.compression_number", "Header compression number"),
    hc_length = ProtoField.uint8("jaus.header.compression_length", "Header compression length"),
    priority = ProtoField.uint8("jaus.header.priority", "Priority", base.DEC, PRIORITIES, 0x03),
    broadcast = ProtoField.uint8("jaus.header.broadcast", "Broadcast", base.DEC, BROADCASTS, 0x0C),
    ack = ProtoField.uint8("jaus.header.ack", "Ack/Nak", base.DEC, ACKS, 0x30),
    data_flag = ProtoField.uint8("jaus.header.data_flag", "Data flag", base.DEC, DATA_FLAGS, 0xC0),
    destination = ProtoField.string("jaus.destination", "Destination"),
    source = ProtoField.string("jaus.source", "Source"),
    sequence = ProtoField.uint16("jaus.header.sequence", "Sequence number"),
    fragment = ProtoField.bytes("jaus.fragment", "Fragment"),
    fragments = ProtoField.uint32("jaus.reassembled.fragments", "Fragments"),
    reassembled_in = ProtoField.framenum("jaus.reassembled.in", "Reassembled in frame"),
    message = ProtoField.string("jaus.message", "Message"),
    id = ProtoField.uint16("jaus.message.id", "Message id", base.HEX),
    service = ProtoField.string("jaus.message.service", "Service"),
    service_version = ProtoField.string("jaus.message.version", "Version of the service"),
    data = ProtoField.bytes("jaus.data", "Data"),
}
local X = {
    truncated = ProtoExpert.new("jaus.malformed.truncated", "The bytes end too soon", expert.group.MALFORMED, expert.severity.ERROR),
    trailing = ProtoExpert.new("jaus.malformed.trailing", "Bytes are left over", expert.group.MALFORMED, expert.severity.WARN),
    value = ProtoExpert.new("jaus.malformed.value", "A value is not allowed", expert.group.MALFORMED, expert.severity.WARN),
    count = ProtoExpert.new("jaus.malformed.count", "A count is not allowed", expert.group.MALFORMED, expert.severity.WARN),
    choice = ProtoExpert.new("jaus.malformed.choice", "An alternative is not defined", expert.group.MALFORMED, expert.severity.ERROR),
    header = ProtoExpert.new("jaus.malformed.header", "The header is not readable", expert.group.MALFORMED, expert.severity.ERROR),
    checksum = ProtoExpert.new("jaus.malformed.checksum", "A checksum is wrong", expert.group.CHECKSUM, expert.severity.ERROR),
    unknown = ProtoExpert.new("jaus.unknown", "The message is not defined", expert.group.UNDECODED, expert.severity.NOTE),
    limit = ProtoExpert.new("jaus.limit", "Too much to show", expert.group.UNDECODED, expert.severity.WARN),
    old = ProtoExpert.new("jaus.old_header", "Older than AS5669A", expert.group.UNDECODED, expert.severity.NOTE),
    failed = ProtoExpert.new("jaus.failed", "The dissector failed", expert.group.UNDECODED, expert.severity.ERROR),
}
jaus.experts = X

-- Fields of the messages ---------------------------------------------------------------------------------------------

local INTEGER_FIELDS = {
    B = ProtoField.uint8, H = ProtoField.uint16, I = ProtoField.uint32, Q = ProtoField.uint64,
    b = ProtoField.int8, h = ProtoField.int16, i = ProtoField.int32, q = ProtoField.int64,
}
local fields = {}
for _, field in pairs(F) do fields[#fields + 1] = field end

local function declare(make, ...)
    local field = make(...)
    fields[#fields + 1] = field
    return field
end

-- Wireshark shows the names of unsigned numbers by itself, and accepts them in filters.
local function integer_field(node, code, mask)
    local names = node.enum and code:upper() == code and code ~= "Q" and ENUMS[node.enum] or nil
    return declare(INTEGER_FIELDS[code], node.path, node.name, base.DEC, names, mask)
end

local declare_node
local DECLARE = {
    number = function(node)
        if node.code == "f" then node.field = declare(ProtoField.float, node.path, node.name)
        elseif node.code == "d" then node.field = declare(ProtoField.double, node.path, node.name)
        else node.field = integer_field(node, node.code) end
    end,
    real = function(node) node.field = declare(ProtoField.double, node.path, node.name) end,
    bits = function(node)
        node.field = declare(INTEGER_FIELDS[node.code], node.path, node.name, base.HEX)
        for _, bit in ipairs(node) do
            local mask = node.code ~= "Q" and bit.mask * 2^bit.shift or nil
            bit.field = integer_field(bit, node.code, mask)
        end
    end,
    choice = function(node)
        node.field = declare(ProtoField.uint8, node.path, node.name, base.DEC, ENUMS[node.enum])
        node.value_field = declare(ProtoField.double, node.value_path, "Value")
    end,
    text = function(node)
        node.field = declare(ProtoField.string, node.path, node.name)
        if node.count then node.count_field = declare(ProtoField.uint32, node.count_path, "Length") end
    end,
    blob = function(node)
        node.field = declare(ProtoField.bytes, node.path, node.name)
        node.count_field = declare(ProtoField.uint32, node.count_path, "Length")
        if node.format_path then
            node.format_field = declare(ProtoField.uint8, node.format_path, "Format", base.DEC, ENUMS[node.enum])
        end
    end,
    grid = function(node) declare_node(node.item) end,
    list = function(node)
        node.count_field = declare(ProtoField.uint32, node.count_path, "Count")
        declare_node(node.item)
    end,
    union = function(node)
        node.field = declare(ProtoField.uint32, node.tag_path, "Alternative", base.DEC, node.names)
        for _, arm in ipairs(node) do declare_node(arm) end
    end,
    record = function(node)
        if node.presence then
            local make = INTEGER_FIELDS[node.presence]
            node.field = declare(make, node.presence_path, "Presence vector", base.HEX)
        end
        for _, part in ipairs(node) do declare_node(part) end
    end,
}
declare_node = function(node) DECLARE[node.kind](node) end

for _, message in pairs(MESSAGES) do declare_node(message.body) end
jaus.fields = fields

-- Reading ------------------------------------------------------------------------------------------------------------

local TOO_MANY = {}             -- raised when a frame has more than MAX_ITEMS

-- %d refuses numbers beyond an integer, which a count of 64 bits may be.
local function shown(value)
    return value == math.floor(value) and string.format("%.0f", value) or string.format("%.9g", value)
end

local function plural(number, word)
    return string.format("%s %s%s", shown(number), word, number == 1 and "" or "s")
end

-- A position in the bytes of a message. `budget` is shared by all of a frame.
local function reader_of(tvb, start, stop, budget, depth)
    return { tvb = tvb, at = start, stop = stop, budget = budget, depth = depth, ended = false }
end

local function spend(budget)
    budget.left = budget.left - 1
    if budget.left < 0 then error(TOO_MANY, 0) end
end

local function complain(reader, tree, what, text)
    spend(reader.budget)
    tree:add_proto_expert_info(what, text)
end

-- The next `size` bytes, or nil if the message ends before; then nothing more can be read.
local function take(reader, size, tree, name)
    if reader.ended then return nil end
    local left = reader.stop - reader.at
    if size > left then
        reader.ended = true
        complain(reader, tree, X.truncated, string.format("%s needs %s, %d left", name, plural(size, "byte"), left))
        return nil
    end
    local range = reader.tvb(reader.at, size)
    reader.at = reader.at + size
    return range
end

local function value_of(range, code)
    if code == "B" or code == "H" or code == "I" then return range:le_uint() end
    if code == "b" or code == "h" or code == "i" then return range:le_int() end
    if code == "f" or code == "d" then return range:le_float() end
    return (code == "Q" and range:le_uint64() or range:le_int64()):tonumber()
end

local function allowed(node, value)
    local names, ranges = node.enum and ENUMS[node.enum], node.ranges
    if not names and not ranges then return true end
    if names and names[value] then return true end
    for i = 1, ranges and #ranges or 0, 2 do
        if ranges[i] <= value and value <= ranges[i + 1] then return true end
    end
    return false
end

local function check(reader, item, node, value)
    if value ~= value or value == math.huge or value == -math.huge then
        complain(reader, item, X.value, node.name .. " is not a finite number")
    elseif not allowed(node, value) then
        complain(reader, item, X.value, string.format("%s: %s is not allowed", node.name, shown(value)))
    end
end

local function annotate(item, node, value)
    local names = node.enum and ENUMS[node.enum]
    if names and names[value] then item:append_text(" (" .. names[value] .. ")") end
    if node.units then item:append_text(" " .. node.units) end
end

local function scaled(node, raw)
    if raw == node.top then return node.upper end
    return node.lower + raw * node.step
end

-- A counted part: the number, or nil. Counts outside their limits are reported and used.
local function counted(reader, tree, node)
    local range = take(reader, SIZES[node.count], tree, node.name)
    if not range then return nil end
    local count = value_of(range, node.count)
    spend(reader.budget)
    local item = tree:add(node.count_field, range, math.min(count, 0xFFFFFFFF))
    if count < node.minimum or count > node.maximum then
        local text = "count %s is outside %s..%s"
        complain(reader, item, X.count, text:format(shown(count), shown(node.minimum), shown(node.maximum)))
    end
    return count
end

local function subtree(reader, tree, name)
    spend(reader.budget)
    local left = reader.stop - reader.at
    return tree:add(reader.tvb(reader.at, math.max(left, 0)), name), reader.at
end

local function close(reader, item, start)
    item:set_len(reader.at - start)
end

local read_node, read_message
local READ = {}

function READ.number(node, reader, tree)
    local range = take(reader, SIZES[node.code], tree, node.name)
    if not range then return end
    spend(reader.budget)
    local item, value = tree:add_le(node.field, range), value_of(range, node.code)
    if node.code == "f" or node.code == "d" or node.code == "Q" or node.code:lower() == node.code then
        annotate(item, node, value)
    elseif node.units then
        item:append_text(" " .. node.units)
    end
    check(reader, item, node, value)
end

function READ.real(node, reader, tree)
    local range = take(reader, SIZES[node.code], tree, node.name)
    if not range then return end
    local raw = value_of(range, node.code)
    spend(reader.budget)
    local item = tree:add(node.field, range, scaled(node, raw))
    if node.units then item:append_text(" " .. node.units) end
    if raw < 0 then complain(reader, item, X.value, string.format("%s: raw value %s is below 0", node.name, shown(raw))) end
end

function READ.bits(node, reader, tree)
    local range = take(reader, SIZES[node.code], tree, node.name)
    if not range then return end
    spend(reader.budget)
    local whole = tree:add_le(node.field, range)
    for _, bit in ipairs(node) do
        spend(reader.budget)
        local item, value
        if node.code == "Q" then
            local part = range:le_uint64():rshift(bit.shift):band(UInt64.max():rshift(64 - bit.width))
            item, value = whole:add(bit.field, range, part), part:tonumber()
            annotate(item, bit, value)
        else
            item, value = whole:add_le(bit.field, range), math.floor(range:le_uint() / 2^bit.shift) % (bit.mask + 1)
        end
        check(reader, item, bit, value)
    end
end

function READ.choice(node, reader, tree)
    local range = take(reader, 1, tree, node.name)
    if not range then return end
    local index = range:uint()
    local chosen = node.items[index]
    spend(reader.budget)
    local item = tree:add(node.field, range)
    if not chosen then
        reader.ended = true
        complain(reader, item, X.choice, string.format("%s: type %d is not defined", node.name, index))
        return
    end
    range = take(reader, SIZES[chosen.code], item, node.name)
    if not range then return end
    local value = value_of(range, chosen.code)
    spend(reader.budget)
    local shown_item = item:add(node.value_field, range, chosen.kind == "real" and scaled(chosen, value) or value)
    annotate(shown_item, chosen, value)
    if chosen.kind == "number" then
        check(reader, shown_item, chosen, value)
    elseif value < 0 then
        complain(reader, shown_item, X.value, string.format("%s: raw value %s is below 0", node.name, shown(value)))
    end
end

function READ.text(node, reader, tree)
    local size = node.length
    if node.count then size = counted(reader, tree, node) end
    local range = size and take(reader, size, tree, node.name)
    if not range then return end
    spend(reader.budget)
    if size == 0 then
        tree:add(node.field, range, "")
    else
        tree:add_packet_field(node.field, range, ENC_ISO_8859_1)
    end
end

function READ.blob(node, reader, tree)
    local format
    if node.format_field then
        local range = take(reader, 1, tree, node.name)
        if not range then return end
        format = range:uint()
        spend(reader.budget)
        local item = tree:add(node.format_field, range)
        if not allowed(node, format) then
            complain(reader, item, X.value, string.format("%s: format %d is not defined", node.name, format))
        end
    end
    local size = counted(reader, tree, node)
    local start = reader.at
    local range = size and take(reader, size, tree, node.name)
    if not range then return end
    spend(reader.budget)
    local item = tree:add(node.field, range)
    if (node.nested == true or (node.nested and node.nested[format])) and size > 0 then
        if reader.depth < MAX_NESTING then
            local inner = reader_of(reader.tvb, start, start + size, reader.budget, reader.depth + 1)
            reader.inner = read_message(inner, item)
        else
            complain(reader, item, X.limit, string.format("messages are nested more than %d deep", MAX_NESTING))
        end
    end
end

local function read_grid(node, reader, tree, level)
    if level > #node.sizes then return read_node(node.item, reader, tree) end
    for _ = 1, node.sizes[level] do
        if reader.ended then return end
        read_grid(node, reader, tree, level + 1)
    end
end

function READ.grid(node, reader, tree)
    local item, start = subtree(reader, tree, node.name)
    read_grid(node, reader, item, 1)
    close(reader, item, start)
end

function READ.list(node, reader, tree)
    local item, start = subtree(reader, tree, node.name)
    local count = counted(reader, item, node) or 0
    for number = 0, count - 1 do
        if reader.ended then break end
        if reader.at >= reader.stop then
            reader.ended = true
            complain(reader, item, X.truncated, "the count says more than " .. plural(number, "item"))
            break
        end
        local element, from = subtree(reader, item, string.format("[%d]", number))
        read_node(node.item, reader, element)
        close(reader, element, from)
    end
    close(reader, item, start)
end

function READ.union(node, reader, tree)
    local item, start = subtree(reader, tree, node.name)
    local range = take(reader, SIZES[node.code], item, node.name)
    if range then
        local tag = value_of(range, node.code)
        spend(reader.budget)
        local tag_item = item:add(node.field, range, math.min(tag, 0xFFFFFFFF))
        local arm = node[tag + 1]
        if arm then
            read_node(arm, reader, item)
        else
            reader.ended = true
            complain(reader, tag_item, X.choice, string.format("%s: alternative %s is not defined", node.name, shown(tag)))
        end
    end
    close(reader, item, start)
end

local function has_bit(range, bit)
    local byte = math.floor(bit / 8)
    if byte >= range:len() then return false end
    return math.floor(range(byte, 1):uint() / 2^(bit % 8)) % 2 == 1
end

local function read_parts(node, reader, tree)
    local vector
    if node.presence then
        vector = take(reader, SIZES[node.presence], tree, node.name .. ": presence vector")
        if not vector then return end
        spend(reader.budget)
        tree:add_le(node.field, vector)
    end
    local bit = 0
    for _, part in ipairs(node) do
        if reader.ended then return end
        if part.optional then
            if vector and has_bit(vector, bit) then read_node(part, reader, tree) end
            bit = bit + 1
        else
            read_node(part, reader, tree)
        end
    end
end

function READ.record(node, reader, tree)
    if node.inline then return read_parts(node, reader, tree) end
    local item, start = subtree(reader, tree, node.name)
    read_parts(node, reader, item)
    close(reader, item, start)
end

read_node = function(node, reader, tree) READ[node.kind](node, reader, tree) end

-- A message from its id on; returns its name, with that of a message in it.
read_message = function(reader, tree)
    local size = reader.stop - reader.at
    local whole = reader.tvb(reader.at, size)
    spend(reader.budget)
    if size < 2 then
        complain(reader, tree:add(F.data, whole), X.truncated, "a message has at least 2 bytes, its id")
        return nil
    end
    local id = reader.tvb(reader.at, 2):le_uint()
    local message = MESSAGES[id]
    if not message then
        local item = tree:add(F.message, whole, string.format("%04Xh", id))
        item:add_le(F.id, reader.tvb(reader.at, 2))
        if size > 2 then item:add(F.data, reader.tvb(reader.at + 2, size - 2)) end
        local meanings = AMBIGUOUS[id]
        local text = meanings and string.format("message %04Xh is %s", id, meanings) or string.format("unknown message %04Xh", id)
        complain(reader, item, X.unknown, text)
        return string.format("message %04Xh", id)
    end
    local item = tree:add(F.message, whole, message.name)
    item:add_le(F.id, reader.tvb(reader.at, 2))
    item:add(F.service, message.service):set_generated()
    item:add(F.service_version, message.version):set_generated()
    reader.at = reader.at + 2
    read_node(message.body, reader, item)
    if not reader.ended and reader.at < reader.stop then
        local left = reader.stop - reader.at
        local rest = item:add(F.data, reader.tvb(reader.at, left))
        complain(reader, rest, X.trailing, plural(left, "byte") .. " left over after the message")
    end
    return reader.inner and string.format("%s (%s)", message.name, reader.inner) or message.name
end

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
