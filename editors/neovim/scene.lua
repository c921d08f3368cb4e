-- Scene files in Neovim: the file type, the server, and colours for the words. Put this file into the folder `plugin` of
-- your configuration, or `:source` it. Works from Neovim 0.7 on; newer ones show more of what the server offers.

local M = {}

--- How the server is called. `settings` is what docs/editor.md lists.
M.command = { "scenec", "lsp" }
M.settings = {}

-- Neovim 0.7 asks for this before it takes file types from Lua.
vim.g.do_filetype_lua = 1
vim.filetype.add({ extension = { scene = "scene", rti = "scene" } })

--- Colours for the words until the server names them, and for a Neovim that can't ask it.
local function words()
  vim.bo.commentstring = "/ %s"
  vim.cmd([[
    syntax clear
    syntax match sceneName /[!?*]\s*\k\+/
    syntax match sceneOperator /:=\|?=\|\*=\|+=\|<=\|#[xyz]=\|[|&]/
    syntax match sceneNumber /\v<\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?/
    syntax keyword sceneConstant pi
    syntax match sceneComment /\/.*$/
    highlight default link sceneName Identifier
    highlight default link sceneOperator Operator
    highlight default link sceneNumber Number
    highlight default link sceneConstant Constant
    highlight default link sceneComment Comment
  ]])
end

--- The one server of this editor.
local client

--- Starts the server for a buffer, or gives the buffer to the one that runs.
function M.attach(buffer)
  words()
  local config = {
    name = "scenec",
    cmd = M.command,
    root_dir = vim.fn.getcwd(),
    init_options = M.settings,
    settings = { scenec = M.settings },
  }
  if vim.lsp.start ~= nil then
    -- From 0.8 on, Neovim keeps count itself.
    vim.lsp.start(config, { bufnr = buffer })
    return
  end
  if client == nil or vim.lsp.get_client_by_id(client) == nil then
    client = vim.lsp.start_client(config)
  end
  if client ~= nil then
    vim.lsp.buf_attach_client(buffer, client)
  end
end

vim.api.nvim_create_autocmd("FileType", {
  pattern = "scene",
  callback = function(event)
    M.attach(event.buf)
  end,
})

return M
