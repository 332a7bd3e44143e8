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
