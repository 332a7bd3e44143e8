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
