-- Runs inside Neovim: `nvim --headless -u NONE -i NONE -n -l` is newer than 0.7, so this is read by `-c luafile`.
-- SCENEC is the program, SCENE_FOLDER a folder of its own. Prints a line for each test and leaves with 1 if one failed.

local here = vim.env.SCENE_EDITORS .. "/neovim"
local scene = dofile(here .. "/scene.lua")
scene.command = { vim.env.SCENEC, "lsp" }

--- How long anything may take, in milliseconds: a machine may be busy.
local PATIENCE = 120000

local passed, failed = 0, 0
local function test(name, run)
  local fine, why = pcall(run)
  passed, failed = passed + (fine and 1 or 0), failed + (fine and 0 or 1)
  io.stdout:write(string.format("%s neovim: %s%s\n", fine and "ok" or "FAILED", name, fine and "" or ": " .. tostring(why)))
end

local function wait(what, ask)
  assert(vim.wait(PATIENCE, ask, 20), "timed out: " .. what)
end

local function request(method, extra)
  local params = vim.tbl_extend("force", { textDocument = vim.lsp.util.make_text_document_params() }, extra or {})
  local answers = vim.lsp.buf_request_sync(0, method, params, PATIENCE)
  for _, answer in pairs(answers or {}) do
    assert(answer.error == nil, vim.inspect(answer.error))
    return answer.result
  end
end

--- The clients of this buffer; newer ones give a list, with other keys.
local function clients()
  return vim.lsp.get_clients and vim.lsp.get_clients({ bufnr = 0 }) or vim.lsp.buf_get_clients(0)
end

local function codes()
  local found = {}
  for _, finding in ipairs(vim.diagnostic.get(0)) do
    found[finding.code or (finding.user_data and finding.user_data.lsp.code)] = true
  end
  return found
end

local lines = vim.fn.readfile(vim.env.SCENE_FILE)
local file = vim.env.SCENE_FOLDER .. "/test.scene"
vim.fn.writefile(lines, file)
vim.cmd("filetype on")
vim.cmd("edit " .. file)
local ball = vim.fn.search("^!ball := sphere$")

test("the file type is scene, and the server is attached", function()
  assert(vim.bo.filetype == "scene", vim.bo.filetype)
  wait("a client", function()
    return next(clients()) ~= nil
  end)
  -- The answer to initialize has to be there before the first request.
  wait("its greeting", function()
    local _, client = next(clients())
    return client.initialized
  end)
end)

test("findings stand under the words", function()
  wait("W005", function()
    return codes().W005
  end)
end)

test("a hover tells of the material", function()
  local row = vim.fn.search("^?red") - 1
  local hover = request("textDocument/hover", { position = { line = row, character = 2 } })
  assert(hover and vim.inspect(hover):find("diffref"), vim.inspect(hover))
end)

test("colours are told", function()
  assert(#request("textDocument/documentColor") >= 2)
end)

test("findings go when the text is mended", function()
  local last = vim.fn.search("^!ball +=") - 1
  vim.api.nvim_buf_set_lines(0, last, last + 1, false, {})
  wait("no findings", function()
    return #vim.diagnostic.get(0) == 0
  end)
  vim.api.nvim_buf_set_lines(0, ball - 1, ball, false, { "!ball := shpere" })
  wait("E008", function()
    return codes().E008
  end)
end)

test("a definition is found in a line with emoji", function()
  vim.api.nvim_buf_set_lines(0, ball - 1, ball, false, { "!ball := sphere" })
  vim.api.nvim_buf_set_lines(0, -1, -1, false, { "!été := ball | ball / 🌍" })
  vim.api.nvim_win_set_cursor(0, { vim.api.nvim_buf_line_count(0), #"!été := b" })
  local _, client = next(clients())
  local place = vim.lsp.util.make_position_params(0, client.offset_encoding)
  local found = request("textDocument/definition", place)
  assert(found and vim.inspect(found):find("line = " .. (ball - 1)), vim.inspect(found))
end)

test("the server ends when it is told to", function()
  local _, client = next(clients())
  client.stop()
  wait("the end", function()
    return client.is_stopped()
  end)
end)

io.stdout:write(string.format("neovim: %d passed, %d failed\n", passed, failed))
vim.cmd(failed == 0 and "qall!" or "cquit 1")
